package org.mechservice.solver.text;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;

/** Reasons of file errors, in words; Java's own messages name classes. */
public final class FileErrors {
  private FileErrors() {}

  /** Returns why a file could not be created or written. */
  public static String reason(IOException trouble) {
    if (trouble instanceof NoSuchFileException) {
      return "the folder it is to be in does not exist";
    } else if (trouble instanceof AccessDeniedException) {
      return "access is denied";
    } else if (trouble instanceof FileAlreadyExistsException existing) {
      return existing.getFile() + " is a file";
    } else if (trouble instanceof FileSystemException other && other.getReason() != null) {
      return other.getReason();
    }
    String message = trouble.getMessage();
    return message == null ? trouble.getClass().getSimpleName() : message;
  }
}
