package org.mechservice.study.run;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.mechservice.guard.UserCode;
import org.mechservice.library.MechModel;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.document.Element;
import org.mechservice.solver.simulation.SolverVersion;
import org.mechservice.solver.text.ModelFiles;
import org.mechservice.solver.text.Sha256;
import org.mechservice.study.PointModel;
import org.mechservice.study.Reduction;
import org.mechservice.study.design.Design;

/** Reads a study file and checks it against its model. */
public final class StudyReader {
  private final Path file;
  private final byte[] content;
  private final StudyDocument document;
  private final Element root;
  private final UserCode userCode;

  private StudyReader(Path file, byte[] content, Map<String, Path> places, UserCode userCode)
      throws MechmlException {
    this.file = file;
    this.content = content;
    this.userCode = userCode;
    document = StudyDocument.read(file, content, places);
    root = document.root();
  }

  /**
   * Reads a study.
   *
   * @param file XML file, or YAML file by the ending of its name; files that it names are sought
   *     beside it
   * @throws IOException if a file cannot be read
   * @throws MechmlException if the study or its model cannot be used; says what, where and what to
   *     write instead
   */
  public static StudyPlan read(Path file) throws IOException, MechmlException {
    return read(file, Files.readAllBytes(file), UserCode.NONE);
  }

  /**
   * Reads a study that need not be a file.
   *
   * @param file its name; files that it names are sought beside it
   * @param content XML, or YAML by the ending of the name
   * @param userCode the folders whose classes of forces may run
   * @throws IOException if a file cannot be read
   * @throws MechmlException if the study or its model cannot be used; says what, where and what to
   *     write instead
   */
  public static StudyPlan read(Path file, byte[] content, UserCode userCode)
      throws IOException, MechmlException {
    return new StudyReader(file, content, Map.of(), userCode).read();
  }

  /**
   * Reads a study whose files are elsewhere.
   *
   * @param places of the files that it names, by these names; others are sought beside it
   * @param userCode the folders whose classes of forces may run
   */
  static StudyPlan read(Path file, Map<String, Path> places, UserCode userCode)
      throws IOException, MechmlException {
    return new StudyReader(file, Files.readAllBytes(file), places, userCode).read();
  }

  private StudyPlan read() throws IOException, MechmlException {
    String name = document.required(root, "model", "the model's file, such as model=\"seat.xml\"");
    document.throwIfErrors();
    Path modelFile = document.place(name);
    if (!Files.isRegularFile(modelFile)) {
      document.error(
          root, "there is no model file " + modelFile + "; it is sought beside the study file");
      document.throwIfErrors();
    }
    MechModel model = model(modelFile);
    List<GivenFactor> factors = new FactorReader(document).read(model);
    Design design = new DesignReader(document).read(factors);
    OutputReader outputs = new OutputReader(document);
    List<Reduction> reductions = outputs.reductions();
    document.throwIfErrors();
    PointModel points = points(model, factors, reductions);
    List<StudyOutput> columns = outputs.columns(reductions, points);
    StopRule stop = outputs.stop(columns);
    document.throwIfErrors();
    List<StudyFactor> shown = factors.stream().map(GivenFactor::factor).toList();
    JsonObject identity = identity(modelFile, points, shown);
    identity.addProperty("points", design.size());
    return new StudyPlan(
        shown.stream().map(StudyFactor::name).toList(),
        design,
        shown,
        columns,
        stop,
        points,
        modelFile,
        tables(),
        identity);
  }

  /** Returns the model with the simulation and the settings that the study asks for. */
  private MechModel model(Path modelFile) throws IOException, MechmlException {
    // By its simple name, as on a host: the code and its messages do not depend on the folder.
    MechModel model = MechModel.read(String.valueOf(modelFile.getFileName()), modelFile, userCode);
    Optional<String> simulation = root.attribute("simulation");
    if (simulation.isPresent()) {
      model = model.simulation(simulation.get());
    }
    List<Element> runs = root.children("run");
    if (runs.size() > 1) {
      document.error(runs.get(1), "the study has two elements <run>; write one");
    }
    for (Element run : runs) {
      try {
        model = RunElement.applied(run, model);
      } catch (StudyRefusal e) {
        document.error(run, "run: " + e.getMessage());
      }
    }
    return model;
  }

  private PointModel points(MechModel model, List<GivenFactor> factors, List<Reduction> reductions)
      throws MechmlException {
    List<String> names = factors.stream().map(f -> f.factor().name()).toList();
    List<Element> outputs = root.children("output");
    for (int i = 0; i < outputs.size(); i++) {
      try {
        PointModel.of(model, List.of(), reductions.subList(i, i + 1));
      } catch (IllegalArgumentException e) {
        document.error(outputs.get(i), String.valueOf(e.getMessage()));
      }
    }
    document.throwIfErrors();
    try {
      return PointModel.of(model, names, reductions);
    } catch (IllegalArgumentException e) {
      document.error(root, String.valueOf(e.getMessage()));
      document.throwIfErrors();
      throw e;
    }
  }

  private List<String> tables() {
    return root.children("table").stream()
        .map(table -> table.attribute("file").map(String::strip).orElse(""))
        .toList();
  }

  private JsonObject identity(Path modelFile, PointModel points, List<StudyFactor> factors)
      throws IOException {
    JsonObject identity = new JsonObject();
    identity.addProperty("study", String.valueOf(file.getFileName()));
    identity.addProperty("studySha256", Sha256.of(content));
    JsonArray tables = new JsonArray();
    for (String table : tables()) {
      tables.add(Sha256.of(Files.readAllBytes(document.place(table))));
    }
    identity.add("tablesSha256", tables);
    identity.addProperty("model", root.attribute("model").map(String::strip).orElse(""));
    byte[] model = ModelFiles.inlined(Files.readAllBytes(modelFile), modelFile);
    identity.addProperty("modelSha256", Sha256.of(model));
    identity.addProperty("codeSha256", points.model().sha256());
    identity.addProperty("version", SolverVersion.CURRENT);
    root.attribute("simulation").ifPresent(name -> identity.addProperty("simulation", name));
    identity.add("run", attributes(root.children("run")));
    identity.add("design", attributes(root.children("design")));
    identity.add("factors", attributes(root.children("factor")));
    identity.add("outputs", attributes(root.children("output")));
    identity.add("stop", attributes(root.children("stop")));
    JsonObject units = new JsonObject();
    factors.forEach(factor -> units.addProperty(factor.name(), factor.unit()));
    identity.add("units", units);
    return identity;
  }

  private static JsonElement attributes(List<Element> elements) {
    JsonArray all = new JsonArray();
    for (Element element : elements) {
      JsonObject one = new JsonObject();
      element.attributes().forEach(a -> one.addProperty(a.name(), a.value()));
      all.add(one);
    }
    return all;
  }
}
