package org.mechservice.study.run;

import java.io.IOException;
import java.io.Serializable;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.TreeMap;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.text.ModelFiles;

/**
 * All files of a study as bytes, so that another machine can read it: the study, its model with the
 * files that this names, its tables, and the classes of the model's forces.
 */
public final class StudyFiles implements Serializable {
  private static final long serialVersionUID = 1L;

  private final String study;
  private final byte[] content;
  private final String model;

  /** Files that the study names, by these names. */
  private final LinkedHashMap<String, byte[]> named;

  /** Class files of forces by binary name. */
  private final TreeMap<String, byte[]> classes;

  private final String identity;

  private StudyFiles(
      String study,
      byte[] content,
      String model,
      Map<String, byte[]> named,
      Map<String, byte[]> classes,
      String identity) {
    this.study = study;
    this.content = content;
    this.model = model;
    this.named = new LinkedHashMap<>(named);
    this.classes = new TreeMap<>(classes);
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
        model,
        named,
        plan.model().model().userClasses(),
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
      Path place =
          places
              .getOrDefault(model, file)
              .resolveSibling(one.getKey().replace('.', '/') + ".class");
      Files.createDirectories(place.resolveSibling("."));
      Files.write(place, one.getValue());
    }
    StudyPlan plan = StudyReader.read(file, places);
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
