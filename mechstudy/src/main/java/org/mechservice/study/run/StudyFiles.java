package org.mechservice.study.run;

import java.io.IOException;
import java.io.Serializable;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.TreeMap;
import org.mechservice.guard.UserCode;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.text.ModelFiles;

/**
 * All files of a study as bytes, so that another machine can read it: the study, its model with the
 * files that this names, its tables, and the classes of the model's forces.
 */
public final class StudyFiles implements Serializable {
  private static final long serialVersionUID = 1L;

  /** Folder of the classes of forces. */
  private static final String CLASSES = "classes";

  private final String study;
  private final byte[] content;

  /** Files that the study names, by these names. */
  private final LinkedHashMap<String, byte[]> named;

  /** Class files of forces by binary name. */
  private final TreeMap<String, byte[]> classes;

  private final boolean unconfined;
  private final String identity;

  private StudyFiles(
      String study,
      byte[] content,
      Map<String, byte[]> named,
      Map<String, byte[]> classes,
      boolean unconfined,
      String identity) {
    this.study = study;
    this.content = content;
    this.named = new LinkedHashMap<>(named);
    this.classes = new TreeMap<>(classes);
    this.unconfined = unconfined;
    this.identity = identity;
  }

  /**
   * Collects the files of a study.
   *
   * @param file the study's file, from which the plan was read
   * @throws IOException if a file cannot be read
   */
  public static StudyFiles of(Path file, StudyPlan plan) throws IOException {
    Map<String, byte[]> named = new LinkedHashMap<>();
    String model = plan.identity().get("model").getAsString();
    named.put(model, ModelFiles.inlined(Files.readAllBytes(plan.modelFile()), plan.modelFile()));
    for (String table : plan.tables()) {
      named.put(table, Files.readAllBytes(file.resolveSibling(table)));
    }
    return new StudyFiles(
        String.valueOf(file.getFileName()),
        Files.readAllBytes(file),
        named,
        plan.model().model().userClasses(),
        plan.model().model().userCode().isUnconfined(),
        plan.identity().toString());
  }

  /** Returns what the lines of the study depend on, as one line. */
  public String identity() {
    return identity;
  }

  /**
   * Writes the files to a folder and reads the study there.
   *
   * @param folder an empty folder; the files are needed as long as the plan
   * @throws IOException S-181 if the study is another one here, such as by another version of the
   *     program; also if a file cannot be written
   * @throws MechmlException if the study cannot be used here
   */
  public StudyPlan read(Path folder) throws IOException, MechmlException {
    Path file = folder.resolve(study);
    Files.write(file, content);
    Map<String, Path> places = new LinkedHashMap<>();
    for (Map.Entry<String, byte[]> one : named.entrySet()) {
      Path own = Files.createDirectory(folder.resolve("file" + places.size()));
      Path place = own.resolve(String.valueOf(Path.of(one.getKey()).getFileName()));
      Files.write(place, one.getValue());
      places.put(one.getKey(), place);
    }
    for (Map.Entry<String, byte[]> one : classes.entrySet()) {
      Path place = folder.resolve(CLASSES).resolve(one.getKey().replace('.', '/') + ".class");
      Files.createDirectories(place.resolveSibling("."));
      Files.write(place, one.getValue());
    }
    // Who began the study has consented to its classes; no machine of a cluster needs to ask again.
    UserCode consent = classes.isEmpty() ? UserCode.NONE : UserCode.in(folder.resolve(CLASSES));
    StudyPlan plan = StudyReader.read(file, places, unconfined ? consent.unconfined() : consent);
    if (!plan.identity().toString().equals(identity)) {
      throw new IOException(
          MessageCode.STUDY_CHANGED
              + " the study is another one on this machine: here "
              + plan.identity()
              + ", where it was begun "
              + identity);
    }
    return plan;
  }
}
