package org.mechservice.guard;

import java.io.File;
import java.io.IOException;
import java.net.URI;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.jar.Attributes.Name;
import java.util.jar.JarFile;
import java.util.jar.Manifest;
import java.util.zip.ZipException;

/**
 * The files of this machine that a Java process needs, as arguments of bubblewrap that show these
 * and no others, read-only. Behind them Java is at {@code /java} and entry i of the class path at
 * {@code /classes/i}, so that the process does not learn the paths of the machine.
 */
final class JavaFiles {
  /** The Java launcher behind the arguments. */
  static final String LAUNCHER = "/java/bin/java";

  /** The libraries of the system that Java is linked with: of glibc, of musl, and of compilers. */
  private static final List<String> LIBRARIES =
      List.of(
          "ld-linux-x86-64.so.2",
          "ld-linux-aarch64.so.1",
          "libc.so.6",
          "libm.so.6",
          "libdl.so.2",
          "libpthread.so.0",
          "librt.so.1",
          "ld-musl-x86_64.so.1",
          "ld-musl-aarch64.so.1",
          "libc.musl-x86_64.so.1",
          "libc.musl-aarch64.so.1",
          "libz.so.1",
          "libstdc++.so.6",
          "libgcc_s.so.1");

  private final List<String> arguments = new ArrayList<>();
  private final List<String> classPath = new ArrayList<>();

  /**
   * Finds the files of the Java that runs here.
   *
   * @param classPath files and folders; those that do not exist are left out, and those that
   *     manifests of its JARs name are added
   * @throws IOException if a file of Java cannot be found
   */
  JavaFiles(String classPath) throws IOException {
    Path home = Path.of(System.getProperty("java.home")).toRealPath();
    show(home.resolve("bin/java"), LAUNCHER);
    show(home.resolve("lib"), "/java/lib");
    show(home.resolve("conf/security"), "/java/conf/security");
    showLinkedSettings(home.resolve("lib"), "*.cfg");
    showLinkedSettings(home.resolve("conf/security"), "*");
    showLibraries();
    Set<Path> entries = new LinkedHashSet<>();
    for (String entry : classPath.split(File.pathSeparator, -1)) {
      if (!entry.isEmpty()) {
        addEntry(Path.of(entry), entries);
      }
    }
    for (Path entry : entries) {
      String shown = "/classes/" + this.classPath.size();
      show(entry, shown);
      this.classPath.add(shown);
    }
  }

  /**
   * Adds an entry of a class path and those that its manifest names: of {@code java -jar} the class
   * path is one JAR, and all others are in its manifest, by paths that lead nowhere behind the wall
   * (JAR File Specification, attribute Class-Path).
   */
  private static void addEntry(Path entry, Set<Path> entries) throws IOException {
    if (!Files.isReadable(entry) || !entries.add(entry.toRealPath())) {
      return;
    }
    if (!Files.isRegularFile(entry)) {
      return;
    }
    try (JarFile jar = new JarFile(entry.toFile())) {
      Manifest manifest = jar.getManifest();
      String others =
          manifest == null ? null : manifest.getMainAttributes().getValue(Name.CLASS_PATH);
      if (others != null) {
        for (String other : others.strip().split(" +", -1)) {
          URI place = entry.toRealPath().toUri().resolve(other);
          if ("file".equals(place.getScheme())) {
            addEntry(Path.of(place), entries);
          }
        }
      }
    } catch (ZipException e) {
      // No JAR: Java finds no classes in it either.
    }
  }

  /** Returns the arguments of bubblewrap; not to be modified. */
  List<String> arguments() {
    return arguments;
  }

  /** Returns the class path behind the arguments. */
  String classPath() {
    return String.join(File.pathSeparator, classPath);
  }

  private void show(Path file, String as) {
    arguments.addAll(List.of("--ro-bind", file.toString(), as));
  }

  /** Shows settings that a distribution keeps elsewhere and that Java finds by links. */
  private void showLinkedSettings(Path folder, String names) throws IOException {
    try (DirectoryStream<Path> files = Files.newDirectoryStream(folder, names)) {
      for (Path file : files) {
        if (Files.isSymbolicLink(file) && Files.exists(file)) {
          Path target = folder.resolve(Files.readSymbolicLink(file)).normalize();
          show(file.toRealPath(), target.toString());
        }
      }
    }
  }

  /** Shows the libraries in the folders where this process has found its own, and in the usual. */
  private void showLibraries() throws IOException {
    Set<Path> folders = new LinkedHashSet<>();
    for (String usual : List.of("/lib", "/lib64", "/usr/lib", "/usr/lib64")) {
      Path folder = Path.of(usual);
      if (Files.isSymbolicLink(folder)) {
        arguments.addAll(List.of("--symlink", Files.readSymbolicLink(folder).toString(), usual));
      }
      if (Files.isDirectory(folder)) {
        folders.add(folder.toRealPath());
      }
    }
    for (String mapping : Files.readAllLines(Path.of("/proc/self/maps"))) {
      int path = mapping.indexOf('/');
      if (path >= 0 && mapping.substring(mapping.lastIndexOf('/')).startsWith("/libc")) {
        folders.add(Path.of(mapping.substring(path)).toRealPath().getParent());
      }
    }
    for (Path folder : folders) {
      for (String name : LIBRARIES) {
        Path library = folder.resolve(name);
        if (Files.exists(library)) {
          show(library.toRealPath(), library.toString());
        }
      }
    }
  }
}
