package org.mechservice.sim.service;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;

/** What is wrong with a file, in words; Java's own messages are names of classes. */
public final class FileTrouble {
  private FileTrouble() {}

  /** Returns why a file could not be created or written. */
  public static String why(IOException trouble) {
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
