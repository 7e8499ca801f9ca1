package org.mechservice.view.web;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.Comparator;
import java.util.stream.Stream;
import org.mechservice.orb.http.RefusedRequestException;
import org.mechservice.solver.text.ModelFiles;

/** The files that a user has put beside a model in the page, in a folder of their own. */
final class DroppedFiles implements AutoCloseable {
  private static final int MOST_FILES = 500;

  private final Path folder;

  private DroppedFiles(Path folder) {
    this.folder = folder;
  }

  /**
   * Takes the files of a request: an object {@code files} of their names, relative to the model's
   * folder, and their bytes in Base64.
   *
   * @throws RefusedRequestException if a name leads out of the folder or there are too many
   */
  static DroppedFiles of(JsonObject body) throws IOException {
    DroppedFiles dropped = new DroppedFiles(Files.createTempDirectory("mechweb"));
    try {
      if (body.get("files") instanceof JsonObject files) {
        if (files.size() > MOST_FILES) {
          throw RefusedRequestException.notUnderstood(
              files.size() + " files lie beside the model, and " + MOST_FILES + " are the most");
        }
        for (String name : files.keySet()) {
          dropped.put(name, files.get(name));
        }
      }
      return dropped;
    } catch (IOException | RuntimeException e) {
      dropped.close();
      throw e;
    }
  }

  private void put(String name, JsonElement content) throws IOException {
    try {
      Path file = folder.resolve(name).normalize();
      if (name.contains("\\") || !file.startsWith(folder) || file.equals(folder)) {
        throw RefusedRequestException.notUnderstood("file " + name + " leads out of the folder");
      }
      byte[] bytes = Base64.getDecoder().decode(content.getAsString());
      Files.createDirectories(file.getParent() == null ? folder : file.getParent());
      Files.write(file, bytes);
    } catch (IllegalArgumentException | IllegalStateException e) {
      throw RefusedRequestException.notUnderstood("file " + name + " cannot be taken");
    }
  }

  /** Returns where the files are. */
  Path folder() {
    return folder;
  }

  /**
   * Returns a model with what the files hold that it names.
   *
   * @throws RefusedRequestException if one of them is missing or cannot be used
   */
  String inlined(String model) {
    try {
      byte[] whole =
          ModelFiles.inlined(model.getBytes(StandardCharsets.UTF_8), folder.resolve("model.xml"));
      return new String(whole, StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new RefusedRequestException(
          400, String.valueOf(e.getMessage()).replace(folder.toString(), "what was dropped here"));
    }
  }

  /** Removes the files. */
  @Override
  public void close() {
    try (Stream<Path> all = Files.walk(folder)) {
      for (Path file : all.sorted(Comparator.reverseOrder()).toList()) {
        Files.deleteIfExists(file);
      }
    } catch (IOException e) {
      folder.toFile().deleteOnExit();
    }
  }
}
