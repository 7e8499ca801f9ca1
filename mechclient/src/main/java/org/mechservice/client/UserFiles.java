package org.mechservice.client;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import org.mechservice.client.failure.InvalidModelException;
import org.mechservice.client.failure.ModelMessage;
import org.mechservice.guard.UserCode;
import org.mechservice.idl.ModelFile;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * Files of user force classes. Only classes that the server requests are searched for, in the
 * folders to whose code the user consents.
 */
final class UserFiles {
  /** Code of a message that names a file of a class which the server needs. */
  static final String MISSING = MessageCode.USER_CLASS_MISSING.code();

  private static final String CLASS = ".class";
  private static final Pattern CLASS_FILE = Pattern.compile("(?:[\\w$]+/)*[\\w$]+\\.class");

  private final Path model;
  private final UserCode consent;
  private final Map<String, ModelFile> found = new LinkedHashMap<>();

  /**
   * @param model the model's file
   */
  UserFiles(Path model, UserCode consent) {
    this.model = model;
    this.consent = consent;
  }

  /** Returns the files found so far. */
  ModelFile[] files() {
    return found.values().toArray(ModelFile[]::new);
  }

  /**
   * Searches for the files that the server misses.
   *
   * @return whether a file was found that the server does not have
   * @throws InvalidModelException S-122 if a class is in several files, S-169 if it lies beside the
   *     model and there is no consent to it
   * @throws IOException if a file cannot be read
   */
  boolean seek(List<ModelMessage> said) throws IOException {
    int before = found.size();
    Optional<String> refusal = Optional.empty();
    for (ModelMessage message : said) {
      String name = message.fileName();
      if (message.code().equals(MISSING) && CLASS_FILE.matcher(name).matches()) {
        String className = name.substring(0, name.length() - CLASS.length());
        seek(className);
        refusal = refusal.or(() -> refusal(className));
      }
    }
    if (found.size() == before && refusal.isPresent()) {
      throw new InvalidModelException(
          MessageCode.USER_CODE_NEEDS_CONSENT.code(), refusal.get(), List.of());
    }
    return found.size() > before;
  }

  private Optional<String> refusal(String className) {
    try {
      return UserCode.refusal(model, className);
    } catch (IOException e) {
      return Optional.empty(); // what cannot be read is not beside the model
    }
  }

  private void seek(String className) throws IOException {
    Set<Path> hits = consent.files(className);
    if (hits.size() > 1) {
      throw new InvalidModelException(
          MessageCode.USER_CLASS_DUPLICATE.code(), UserCode.duplicate(className, hits), List.of());
    }
    for (Path hit : hits) {
      String end = hit.toString().endsWith(CLASS) ? CLASS : ".java";
      found.putIfAbsent(hit.toString(), new ModelFile(className + end, Files.readAllBytes(hit)));
    }
  }
}
