package org.mechservice.sim.service.library;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.regex.Pattern;
import org.mechservice.idl.DiagnosticSeqHolder;
import org.mechservice.idl.InvalidModel;
import org.mechservice.idl.ModelFile;
import org.mechservice.idl.NotAvailable;
import org.mechservice.mechml.diagnosis.Diagnostic;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.document.DocumentWriter;
import org.mechservice.robot.RobotImport;
import org.mechservice.sim.service.contract.ContractErrors;
import org.mechservice.sim.service.contract.ContractTypes;

/** Translates models of other formats. */
public final class ModelImport {
  /** Endings of the names of robots; MJCF is also written as .xml. */
  private static final List<String> ROBOTS = List.of(".urdf", ".sdf", ".mjcf", ".xml");

  private static final Pattern ENDING = Pattern.compile("\\.[^./\\\\]*$");

  private ModelImport() {}

  /**
   * Translates a file into MechML.
   *
   * @param foreign the file; the suffix of its name is its format
   * @param losses receives the parts that are not in the result, then the warnings of the model
   * @throws InvalidModel if the file cannot be used
   * @throws NotAvailable if its format is not known
   */
  public static ModelFile translate(ModelFile foreign, DiagnosticSeqHolder losses)
      throws InvalidModel, NotAvailable {
    String name = foreign.fileName.toLowerCase(Locale.ROOT);
    if (ROBOTS.stream().noneMatch(name::endsWith)) {
      throw ContractErrors.notAvailable(
          "robots are imported from URDF, SDF and MJCF, whose names end in .urdf, .sdf, .mjcf or"
              + " .xml; this is "
              + foreign.fileName);
    }
    try {
      RobotImport imported = RobotImport.of(foreign.fileName, foreign.content);
      List<Diagnostic> said = new ArrayList<>(imported.losses());
      said.addAll(ModelWarnings.of(imported.model()));
      losses.value = ContractTypes.diagnostics(said);
      return new ModelFile(
          ENDING.matcher(foreign.fileName).replaceFirst("") + ".xml",
          DocumentWriter.write(imported.document()).getBytes(StandardCharsets.UTF_8));
    } catch (MechmlException e) {
      throw ContractErrors.model(e.diagnostics());
    }
  }
}
