package org.mechservice.library;

import java.io.IOException;
import java.lang.ref.SoftReference;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import org.mechservice.guard.UserCode;
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
  private final Optional<Path> file;
  private final UserCode consent;

  /** The validated content, kept as long as memory suffices. */
  private final AtomicReference<SoftReference<ValidatedFile>> validated = new AtomicReference<>();

  private MechmlFile(String name, byte[] content, Optional<Path> file, UserCode consent) {
    this.name = name;
    this.content = content;
    this.file = file;
    this.consent = consent;
  }

  /**
   * Takes a file with the files that it includes.
   *
   * @param name of the file in messages
   * @param consent to classes of forces
   * @throws IOException if a file cannot be read
   */
  static MechmlFile of(String name, Path file, UserCode consent) throws IOException {
    byte[] content = ModelFiles.inlined(Files.readAllBytes(file), file);
    return new MechmlFile(name, content, Optional.of(file.toRealPath()), consent);
  }

  /** Takes a text that is no file and names no classes of forces. */
  static MechmlFile of(String name, String mechml) {
    byte[] content = mechml.getBytes(StandardCharsets.UTF_8);
    return new MechmlFile(name, content, Optional.empty(), UserCode.NONE);
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
    byte[] content = mechml.getBytes(StandardCharsets.UTF_8);
    return new MechmlFile(name, content, Optional.of(robot.toRealPath()), UserCode.NONE);
  }

  /** Returns its name in messages. */
  String name() {
    return name;
  }

  /** Returns the folder of the file; empty if it is no file. */
  Optional<Path> folder() {
    return file.map(path -> path.resolveSibling("."));
  }

  /** Returns its text, with the files that it includes. */
  String text() {
    return ModelFiles.text(content);
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

  /** Returns the consent to classes of forces. */
  UserCode consent() {
    return consent;
  }

  /**
   * Returns the classes that the forces of its mechanism name.
   *
   * @throws IOException if a file cannot be read
   * @throws MechmlException if a class is not found, or cannot be used
   */
  UserClasses userClasses(Mechanism mechanism) throws IOException, MechmlException {
    return ForceFiles.sought(mechanism, name, file, consent);
  }
}
