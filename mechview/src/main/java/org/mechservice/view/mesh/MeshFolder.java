package org.mechservice.view.mesh;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;

/** The folder of a model file, with the geometry files that the model may name. */
public final class MeshFolder {
  /** Bytes that one geometry file may have. */
  private static final int MOST_BYTES = 64 << 20;

  private final Path folder;

  /** Names the folder that holds the model file. */
  public MeshFolder(Path folder) {
    this.folder = folder;
  }

  /**
   * Reads a geometry file.
   *
   * @param name {@code graphSrc} of the model file: a path relative to the model's folder, inside
   *     it
   * @return surfaces in body axes, m
   * @throws MeshException naming the file, if it lies elsewhere, is missing, too large, of an
   *     unknown kind or damaged
   */
  public List<Mesh> read(String name) throws MeshException {
    try {
      Path file = inside(name);
      byte[] content = content(file);
      String lower = name.toLowerCase(Locale.ROOT);
      if (lower.endsWith(".wrl") || lower.endsWith(".vrml")) {
        return new VrmlReader().read(content);
      } else if (lower.endsWith(".stl")) {
        return List.of(StlReader.read(content));
      } else if (lower.endsWith(".obj")) {
        return List.of(ObjReader.read(content));
      } else if (lower.endsWith(".glb") || lower.endsWith(".gltf")) {
        return GltfReader.read(content);
      }
      throw new MeshException(
          "its name must end in .wrl (VRML 97), .stl, .obj, .glb or .gltf (glTF 2.0)");
    } catch (MeshException e) {
      throw new MeshException("graphSrc " + MeshNumbers.quoted(name) + ": " + e.getMessage());
    }
  }

  private Path inside(String name) throws MeshException {
    if (name.matches("(?s)[A-Za-z][A-Za-z0-9+.-]+:.*")) {
      throw new MeshException("it is a URL; name a file in the model's folder");
    }
    Path given;
    try {
      given = Path.of(name);
    } catch (InvalidPathException e) {
      throw new MeshException("it is no file name");
    }
    if (given.isAbsolute() || name.startsWith("\\") || name.matches("(?s)[A-Za-z]:.*")) {
      throw new MeshException("it is an absolute path; name a file in the model's folder");
    }
    if (name.matches("(?s)(.*[/\\\\])?\\.\\.([/\\\\].*)?")) {
      throw new MeshException("it leads out of the model's folder by \"..\"");
    }
    Path file = folder.resolve(given);
    try {
      Path real = file.toRealPath();
      if (!real.startsWith(folder.toRealPath())) {
        throw new MeshException("it is a link that leads out of the model's folder");
      }
      if (!Files.isRegularFile(real)) {
        throw new MeshException("it is no file");
      }
      return real;
    } catch (MeshException e) {
      throw e;
    } catch (IOException e) {
      throw new MeshException("there is no such file in " + folder);
    }
  }

  private static byte[] content(Path file) throws MeshException {
    try (InputStream in = Files.newInputStream(file)) {
      byte[] content = in.readNBytes(MOST_BYTES + 1);
      if (content.length > MOST_BYTES) {
        throw new MeshException("it has more than " + (MOST_BYTES >> 20) + " MiB");
      }
      return content;
    } catch (MeshException e) {
      throw e;
    } catch (IOException e) {
      throw new MeshException("it cannot be read: " + e.getMessage());
    }
  }
}
