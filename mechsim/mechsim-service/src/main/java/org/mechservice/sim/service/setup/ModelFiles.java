package org.mechservice.sim.service.setup;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.mechservice.sim.user.UserFile;
import org.mechservice.solver.text.Sha256;

/**
 * A model as a client has sent it.
 *
 * @param fileName its name, for messages
 * @param content its bytes; not to be modified
 * @param userFiles sources and class files of its forces
 * @param compile whether sources may be compiled
 * @param bounds what reading may come upon
 */
@SuppressWarnings("ArrayRecordComponent") // never compared; bytes as they came
public record ModelFiles(
    String fileName,
    byte[] content,
    List<UserFile> userFiles,
    boolean compile,
    ReadingBounds bounds) {
  public ModelFiles {
    userFiles = List.copyOf(userFiles);
  }

  /** Returns the SHA-256 of the model's bytes, lower-case hexadecimal. */
  public String sha256() {
    return Sha256.of(content);
  }

  /** Returns the model's bytes as UTF-8, for people to look at. */
  public String text() {
    return new String(content, StandardCharsets.UTF_8);
  }

  /** Returns what identifies the model with its files. */
  String key() {
    ByteArrayOutputStream all = new ByteArrayOutputStream();
    all.writeBytes(name(fileName + '|' + compile + '|' + bounds));
    all.writeBytes(name(sha256()));
    for (UserFile file : userFiles) {
      all.writeBytes(name(file.name() + '|' + Sha256.of(file.content())));
    }
    return Sha256.of(all.toByteArray());
  }

  private static byte[] name(String text) {
    return (text + '|').getBytes(StandardCharsets.UTF_8);
  }
}
