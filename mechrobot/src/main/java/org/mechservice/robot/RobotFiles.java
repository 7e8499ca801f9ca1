package org.mechservice.robot;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.diagnosis.SourcePosition;
import org.mechservice.mechml.document.Content;
import org.mechservice.mechml.document.DocumentReader;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.document.Limits;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * The files beside a robot's: parts that it includes, models, meshes. A name is a path beside the
 * file that has it, {@code file://PATH}, or {@code package://NAME/PATH} and {@code
 * model://NAME/PATH}: the folder NAME is sought in the folders of the user, and in the folders
 * around the robot.
 */
final class RobotFiles {
  private static final Pattern PACKAGE = Pattern.compile("(?:package|model)://([^/]+)/?(.*)");

  /** Bytes of a mesh that is read. */
  private static final long MESH_BYTES = 256L << 20;

  private final Optional<Path> folder;
  private final List<Path> paths;
  private final Map<Path, Optional<Element>> read = new HashMap<>();
  private int elements;

  private RobotFiles(Optional<Path> folder, List<Path> paths) {
    this.folder = folder;
    this.paths = List.copyOf(paths);
  }

  /** No files: a robot that came without its folder. */
  static RobotFiles none() {
    return new RobotFiles(Optional.empty(), List.of());
  }

  /**
   * The files around a robot.
   *
   * @param folder of the robot's file
   * @param paths further folders with packages and models
   */
  static RobotFiles in(Path folder, List<Path> paths) {
    return new RobotFiles(Optional.of(folder.toAbsolutePath().normalize()), paths);
  }

  /** Returns the folder of the robot's file; empty if no other files can be read. */
  Optional<Path> folder() {
    return folder;
  }

  /**
   * Returns the file or folder of a name, if there is one.
   *
   * @param name as the robot's file writes it
   * @param from folder of the file that has the name
   */
  Optional<Path> find(String name, Path from) {
    if (folder.isEmpty()) {
      return Optional.empty();
    }
    try {
      Matcher inPackage = PACKAGE.matcher(name);
      if (inPackage.matches()) {
        return inPackage(inPackage.group(1), inPackage.group(2));
      }
      String plain = name.startsWith("file://") ? name.substring("file://".length()) : name;
      Path file = from.resolve(plain).normalize();
      if (Files.exists(file)) {
        return Optional.of(file);
      }
      return paths.stream()
          .map(path -> path.resolve(plain).normalize())
          .filter(Files::exists)
          .findFirst();
    } catch (InvalidPathException e) {
      return Optional.empty();
    }
  }

  private Optional<Path> inPackage(String name, String rest) {
    List<Path> places = new ArrayList<>(paths);
    folder.ifPresent(
        start -> {
          for (Path around = start; around != null; around = around.getParent()) {
            places.add(around);
          }
        });
    for (Path place : places) {
      Path inside = place.resolve(name).resolve(rest).normalize();
      if (Files.exists(inside)) {
        return Optional.of(inside);
      }
      Path itself = place.resolve(rest).normalize();
      if (place.endsWith(name) && Files.exists(itself)) {
        return Optional.of(itself);
      }
    }
    return Optional.empty();
  }

  /**
   * Returns the outermost element of an XML file that an element names; empty after an error.
   *
   * @param asking the element that names the file, for messages
   * @param name the file as it is named
   * @param from folder of the file that has the name
   */
  Optional<Element> read(Element asking, String name, Path from, Diagnostics diagnostics) {
    Optional<Path> file = find(name, from);
    if (file.isEmpty()) {
      missing(asking, name, diagnostics);
      return Optional.empty();
    }
    return read(asking, file.get(), diagnostics);
  }

  /** Returns the outermost element of an XML file; empty after an error. */
  Optional<Element> read(Element asking, Path file, Diagnostics diagnostics) {
    Optional<Element> done = read.get(file);
    if (done == null) {
      done = parsed(asking, file, diagnostics);
      read.put(file, done);
    }
    done.ifPresent(
        root -> {
          elements += count(root);
          if (elements > Limits.ELEMENTS) {
            diagnostics.error(
                MessageCode.MODEL_FILE_TOO_LARGE,
                asking.position(),
                "the included files have more than " + Limits.ELEMENTS + " elements together");
          }
        });
    return diagnostics.hasErrors() ? Optional.empty() : done;
  }

  private static Optional<Element> parsed(Element asking, Path file, Diagnostics diagnostics) {
    try {
      byte[] content = bytes(file, Limits.BYTES);
      Diagnostics own = new Diagnostics(file.toString());
      return Optional.of(placed(DocumentReader.readForeign(content, own), file.toString()));
    } catch (MechmlException e) {
      diagnostics.addAll(e.diagnostics());
    } catch (IOException e) {
      diagnostics.error(
          MessageCode.ROBOT_FILE,
          asking.position(),
          Phrase.of("%s: %s cannot be read", asking.label(), Quoted.plain(file.toString())));
    }
    return Optional.empty();
  }

  /** Reports that a file does not exist. */
  void missing(Element asking, String name, Diagnostics diagnostics) {
    diagnostics.error(
        MessageCode.ROBOT_FILE,
        asking.position(),
        Phrase.of(
            folder.isEmpty()
                ? "%s names the file %s, and only this file is read; import it with mech import"
                    + " from its folder, or write the robot as one file first"
                : "%s names the file %s, which does not exist; give the folder that holds it with"
                    + " --path",
            asking.label(),
            Quoted.of(name)));
  }

  /**
   * Returns the bytes of a mesh.
   *
   * @throws IOException if it cannot be read or is too large
   */
  static byte[] mesh(Path file) throws IOException {
    return bytes(file, MESH_BYTES);
  }

  private static byte[] bytes(Path file, long most) throws IOException {
    if (Files.size(file) > most) {
      throw new IOException("the file has more than " + most + " bytes");
    }
    return Files.readAllBytes(file);
  }

  private static int count(Element element) {
    int all = 1;
    for (Element child : element.children()) {
      all += count(child);
    }
    return all;
  }

  /** Returns an element whose positions are those of an included file. */
  private static Element placed(Element element, String file) {
    List<Content> content = new ArrayList<>();
    for (Content part : element.content()) {
      content.add(part instanceof Element child ? placed(child, file) : part);
    }
    SourcePosition position = element.position().in(file);
    return new Element(element.name(), element.attributes(), content, position, element.owner());
  }
}
