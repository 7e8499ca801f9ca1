package org.mechservice.library;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.mechservice.guard.UserCode;
import org.mechservice.mechml.diagnosis.Diagnostic;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.sim.user.UserClasses;
import org.mechservice.sim.user.UserFile;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.catalogue.Severity;
import org.mechservice.solver.mechanism.Mechanism;

/** The files of the classes that the forces of a model name, and of those that these need. */
final class ForceFiles {
  private static final String CLASS = ".class";

  private ForceFiles() {}

  /**
   * Seeks them, as sources or class files, in the folders of a consent.
   *
   * @param name of the model in messages
   * @param model the model's file; empty if it is none
   * @throws MechmlException if one is not found, there is no consent to it (S-169), or it cannot be
   *     used
   * @throws IOException if a file cannot be read
   */
  static UserClasses sought(
      Mechanism mechanism, String name, Optional<Path> model, UserCode consent)
      throws IOException, MechmlException {
    Map<Path, UserFile> found = new LinkedHashMap<>();
    while (true) {
      int before = found.size();
      try {
        return UserClasses.admit(mechanism, List.copyOf(found.values()), true)
            .forThisProcess(consent);
      } catch (MechmlException e) {
        List<Diagnostic> refused = new ArrayList<>();
        for (Diagnostic said : e.diagnostics()) {
          if (said.code() == MessageCode.USER_CLASS_MISSING && said.file().endsWith(CLASS)) {
            String wanted = said.file().substring(0, said.file().length() - CLASS.length());
            addFiles(name, wanted, consent, found);
            if (found.size() == before && model.isPresent()) {
              UserCode.refusal(model.get(), wanted)
                  .ifPresent(
                      why -> refused.add(error(name, MessageCode.USER_CODE_NEEDS_CONSENT, why)));
            }
          }
        }
        if (found.size() == before) {
          throw refused.isEmpty() ? e : new MechmlException(refused);
        }
      }
    }
  }

  private static void addFiles(
      String name, String className, UserCode consent, Map<Path, UserFile> found)
      throws IOException, MechmlException {
    Set<Path> files = consent.files(className);
    if (files.size() > 1) {
      throw new MechmlException(
          List.of(
              error(name, MessageCode.USER_CLASS_DUPLICATE, UserCode.duplicate(className, files))));
    }
    for (Path file : files) {
      String end = file.toString().endsWith(CLASS) ? CLASS : ".java";
      found.putIfAbsent(file, new UserFile(className + end, Files.readAllBytes(file)));
    }
  }

  private static Diagnostic error(String name, MessageCode code, String text) {
    return new Diagnostic(Severity.ERROR, code, text, name, 0, 0, "");
  }
}
