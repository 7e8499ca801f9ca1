package org.mechservice.library;

import java.io.IOException;
import java.lang.ref.SoftReference;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.ReadOptions;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.document.DocumentWriter;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.ValidatedFile;
import org.mechservice.robot.ImportOptions;
import org.mechservice.robot.RobotImport;
import org.mechservice.sim.user.UserClasses;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.text.ModelFiles;
import org.mechservice.solver.text.Sha256;

/**
 * The source of a model: the text of a file, of a program or of a translated robot. It is kept, so
 * that a model with other values of its parameters is read from the same bytes.
 */
final class MechmlFile {
  private final String name;
  private final byte[] content;
  private final List<Path> folders;

  /** The validated content, kept as long as memory suffices. */
  private final AtomicReference<SoftReference<ValidatedFile>> validated = new AtomicReference<>();

  private MechmlFile(String name, byte[] content, List<Path> folders) {
    this.name = name;
    this.content = content;
    this.folders = List.copyOf(folders);
  }

  /**
   * Takes a file with the files that it includes.
   *
   * @param name of the file in messages
   * @param userCode folders beside the file's own in which classes of forces are sought
   * @throws IOException if a file cannot be read
   */
  static MechmlFile of(String name, Path file, List<Path> userCode) throws IOException {
    List<Path> folders = new ArrayList<>();
    folders.add(folder(file));
    folders.addAll(userCode);
    return new MechmlFile(name, ModelFiles.inlined(Files.readAllBytes(file), file), folders);
  }

  /** Takes a text that is no file and names no classes of forces. */
  static MechmlFile of(String name, String mechml) {
    return new MechmlFile(name, mechml.getBytes(StandardCharsets.UTF_8), List.of());
  }

  /**
   * Translates a robot in URDF, SDF or MJCF.
   *
   * @throws IOException if the file cannot be read
   * @throws MechmlException if it is no robot
   */
  static MechmlFile ofRobot(Path robot) throws IOException, MechmlException {
    String name = robot.toString();
    RobotImport translated = RobotImport.read(robot, ImportOptions.NONE);
    String mechml = DocumentWriter.write(translated.document());
    return new MechmlFile(name, mechml.getBytes(StandardCharsets.UTF_8), List.of(folder(robot)));
  }

  private static Path folder(Path file) throws IOException {
    return file.toRealPath().resolveSibling(".");
  }

  /** Returns its name in messages. */
  String name() {
    return name;
  }

  /** Returns the folder of the file; empty if it is no file. */
  Optional<Path> folder() {
    return folders.stream().findFirst();
  }

  /** Returns the SHA-256 of its bytes. */
  String sha256() {
    return Sha256.of(content);
  }

  /**
   * Returns the model that it describes.
   *
   * @throws MechmlException if the model cannot be used
   */
  MechmlModel model(ReadOptions reading) throws MechmlException {
    return validated().model(reading);
  }

  /**
   * Returns its outermost element.
   *
   * @throws MechmlException if it is no document of MechML
   */
  Element root() throws MechmlException {
    return validated().root();
  }

  private ValidatedFile validated() throws MechmlException {
    SoftReference<ValidatedFile> latest = validated.get();
    ValidatedFile known = latest == null ? null : latest.get();
    if (known == null) {
      known = ValidatedFile.of(name, content);
      validated.set(new SoftReference<>(known));
    }
    return known;
  }

  /**
   * Returns the classes that the forces of its mechanism name.
   *
   * @throws IOException if a file cannot be read
   * @throws MechmlException if a class is not found, or cannot be used
   */
  UserClasses userClasses(Mechanism mechanism) throws IOException, MechmlException {
    return ForceFiles.sought(mechanism, folders);
  }
}
