package org.mechservice.client;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Pattern;
import org.mechservice.client.failure.InvalidModelException;
import org.mechservice.client.failure.ModelMessage;
import org.mechservice.idl.ModelFile;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * Files of user force classes. Only classes that the server requests are searched for, beside the
 * model and in the folders that the user names.
 */
final class UserFiles {
  /** Code of a message that names a file of a class which the server needs. */
  static final String MISSING = MessageCode.USER_CLASS_MISSING.code();

  private static final String CLASS = ".class";
  private static final Pattern CLASS_FILE = Pattern.compile("(?:[\\w$]+/)*[\\w$]+\\.class");

  private final List<Path> folders = new ArrayList<>();
  private final Map<String, ModelFile> found = new LinkedHashMap<>();

  /**
   * @param model the model's file; its folder is searched
   * @param userCode other folders to search
   * @throws IOException if a folder cannot be read
   */
  UserFiles(Path model, List<Path> userCode) throws IOException {
    folders.add(model.toRealPath().resolveSibling(".").normalize());
    for (Path folder : userCode) {
      folders.add(folder.toRealPath());
    }
  }

  /** Returns the files found so far. */
  ModelFile[] files() {
    return found.values().toArray(ModelFile[]::new);
  }

  /**
   * Searches for the files that the server misses.
   *
   * @return whether a file was found that the server does not have
   * @throws InvalidModelException S-122 if a class is in several files
   * @throws IOException if a file cannot be read
   */
  boolean seek(List<ModelMessage> said) throws IOException {
    int before = found.size();
    for (ModelMessage message : said) {
      String name = message.fileName();
      if (message.code().equals(MISSING) && CLASS_FILE.matcher(name).matches()) {
        seek(name.substring(0, name.length() - CLASS.length()));
      }
    }
    return found.size() > before;
  }

  private void seek(String className) throws IOException {
    String simple = className.substring(className.lastIndexOf('/') + 1);
    Set<Path> hits = new LinkedHashSet<>();
    for (Path folder : folders) {
      for (String place : List.of(simple, className)) {
        for (String end : List.of(".java", CLASS)) {
          addHit(folder, place + end, hits);
        }
      }
    }
    if (hits.size() > 1) {
      throw new InvalidModelException(
          MessageCode.USER_CLASS_DUPLICATE.code(),
          "the class "
              + className.replace('/', '.')
              + " is in several files: "
              + String.join(", ", hits.stream().map(Path::toString).toList())
              + "; keep one of them",
          List.of());
    }
    for (Path hit : hits) {
      String end = hit.toString().endsWith(CLASS) ? CLASS : ".java";
      found.putIfAbsent(hit.toString(), new ModelFile(className + end, Files.readAllBytes(hit)));
    }
  }

  /** Adds a file that was found; a link that leads out of the folder is ignored. */
  private static void addHit(Path folder, String name, Set<Path> hits) throws IOException {
    Path file = folder.resolve(name);
    if (Files.isRegularFile(file)) {
      Path real = file.toRealPath();
      if (real.startsWith(folder)) {
        hits.add(real);
      }
    }
  }
}
