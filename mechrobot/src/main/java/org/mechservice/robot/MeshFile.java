package org.mechservice.robot;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.mechservice.solver.spatial.Vector3;

/** Reads the triangles of a mesh in STL (text or binary), OBJ, or MuJoCo's MSH. */
final class MeshFile {
  private static final int STL_HEAD = 84;
  private static final int STL_TRIANGLE = 50;

  private MeshFile() {}

  /**
   * A surface of one colour.
   *
   * @param colour red, green, blue and opacity from 0 to 1; empty if the file leaves it open
   */
  record Part(TriangleMesh surface, Optional<List<Double>> colour) {}

  /**
   * Reads a mesh with its colours, for pictures; also one in COLLADA.
   *
   * @throws IOException as {@link #read}
   */
  static List<Part> parts(Path file) throws IOException {
    if (String.valueOf(file.getFileName()).toLowerCase(Locale.ROOT).endsWith(".dae")) {
      try {
        return ColladaFile.read(RobotFiles.mesh(file));
      } catch (RuntimeException e) {
        throw new IOException("it is damaged", e);
      }
    }
    return List.of(new Part(read(file), Optional.empty()));
  }

  /**
   * Reads a mesh.
   *
   * @throws IOException if it cannot be read, is of another format, or is damaged; the message says
   *     why
   */
  static TriangleMesh read(Path file) throws IOException {
    byte[] content = RobotFiles.mesh(file);
    String name = String.valueOf(file.getFileName()).toLowerCase(Locale.ROOT);
    try {
      if (name.endsWith(".stl")) {
        return isBinary(content) ? binaryStl(content) : textStl(content);
      } else if (name.endsWith(".obj")) {
        return obj(content);
      } else if (name.endsWith(".msh")) {
        return msh(content);
      }
    } catch (RuntimeException e) {
      throw new IOException("it is damaged", e);
    }
    throw new IOException("it is no mesh in STL, OBJ, MSH or COLLADA");
  }

  private static boolean isBinary(byte[] content) {
    return content.length >= STL_HEAD
        && content.length >= STL_HEAD + (long) STL_TRIANGLE * little(content).getInt(STL_HEAD - 4);
  }

  private static ByteBuffer little(byte[] content) {
    return ByteBuffer.wrap(content).order(ByteOrder.LITTLE_ENDIAN);
  }

  private static TriangleMesh binaryStl(byte[] content) {
    ByteBuffer in = little(content);
    int count = in.getInt(STL_HEAD - 4);
    Corners corners = new Corners();
    for (int i = 0; i < count; i++) {
      int at = STL_HEAD + STL_TRIANGLE * i + 12;
      int[] face = new int[3];
      for (int k = 0; k < 3; k++) {
        face[k] =
            corners.index(
                new Vector3(
                    in.getFloat(at + 12 * k),
                    in.getFloat(at + 12 * k + 4),
                    in.getFloat(at + 12 * k + 8)));
      }
      corners.faces.add(face);
    }
    return corners.mesh();
  }

  private static TriangleMesh textStl(byte[] content) {
    Corners corners = new Corners();
    List<Integer> open = new ArrayList<>();
    for (String line : new String(content, StandardCharsets.ISO_8859_1).lines().toList()) {
      String[] words = line.strip().split("\\s+", -1);
      if (words[0].equals("vertex")) {
        open.add(corners.index(vector(words)));
      } else if (words[0].equals("endfacet")) {
        corners.faces.add(new int[] {open.get(0), open.get(1), open.get(2)});
        open.clear();
      }
    }
    return corners.mesh();
  }

  private static Vector3 vector(String[] words) {
    return new Vector3(
        Double.parseDouble(words[1]), Double.parseDouble(words[2]), Double.parseDouble(words[3]));
  }

  private static TriangleMesh obj(byte[] content) {
    List<Vector3> points = new ArrayList<>();
    List<int[]> faces = new ArrayList<>();
    for (String line : new String(content, StandardCharsets.ISO_8859_1).lines().toList()) {
      String[] words = line.strip().split("\\s+", -1);
      if (words[0].equals("v")) {
        points.add(vector(words));
      } else if (words[0].equals("f")) {
        int[] corners = new int[words.length - 1];
        for (int i = 0; i < corners.length; i++) {
          int given = Integer.parseInt(words[i + 1].split("/", -1)[0]);
          corners[i] = given < 0 ? points.size() + given : given - 1;
        }
        for (int i = 2; i < corners.length; i++) {
          faces.add(new int[] {corners[0], corners[i - 1], corners[i]});
        }
      }
    }
    return new TriangleMesh(points, faces);
  }

  /** Counts of points, normals, texture points and faces, then each as 32-bit numbers. */
  private static TriangleMesh msh(byte[] content) {
    ByteBuffer in = little(content);
    int pointCount = in.getInt();
    int normals = in.getInt();
    int texture = in.getInt();
    int faceCount = in.getInt();
    List<Vector3> points = new ArrayList<>();
    for (int i = 0; i < pointCount; i++) {
      points.add(new Vector3(in.getFloat(), in.getFloat(), in.getFloat()));
    }
    in.position(in.position() + 12 * normals + 8 * texture);
    List<int[]> faces = new ArrayList<>();
    for (int i = 0; i < faceCount; i++) {
      faces.add(new int[] {in.getInt(), in.getInt(), in.getInt()});
    }
    return new TriangleMesh(points, faces);
  }

  /** Corners of triangles, each once. */
  private static final class Corners {
    private final Map<Vector3, Integer> known = new HashMap<>();
    private final List<Vector3> points = new ArrayList<>();
    private final List<int[]> faces = new ArrayList<>();

    int index(Vector3 point) {
      return known.computeIfAbsent(
          point,
          key -> {
            points.add(key);
            return points.size() - 1;
          });
    }

    TriangleMesh mesh() {
      return new TriangleMesh(points, faces);
    }
  }
}
