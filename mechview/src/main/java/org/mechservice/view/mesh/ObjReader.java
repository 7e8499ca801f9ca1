package org.mechservice.view.mesh;

import java.nio.charset.StandardCharsets;
import java.util.StringTokenizer;

/** Reads corners and faces of Wavefront OBJ; textures, normals and materials are left out. */
final class ObjReader {
  private ObjReader() {}

  static Mesh read(byte[] content) throws MeshException {
    MeshBuilder mesh = new MeshBuilder();
    long corners = 0;
    int line = 0;
    for (String text : new String(content, StandardCharsets.UTF_8).split("\\R", -1)) {
      line++;
      StringTokenizer words = new StringTokenizer(text);
      String kind = words.hasMoreTokens() ? words.nextToken() : "";
      try {
        if (kind.equals("v")) {
          corners = 1L + mesh.corner(number(words), number(words), number(words));
        } else if (kind.equals("f")) {
          face(mesh, words, corners);
        }
      } catch (MeshException e) {
        throw new MeshException("line " + line + ": " + e.getMessage());
      }
    }
    return mesh.mesh();
  }

  private static double number(StringTokenizer words) throws MeshException {
    return MeshNumbers.number(words.hasMoreTokens() ? words.nextToken() : "");
  }

  private static void face(MeshBuilder mesh, StringTokenizer words, long corners)
      throws MeshException {
    long[] around = new long[words.countTokens()];
    for (int i = 0; i < around.length; i++) {
      // corner/texture/normal; negative numbers count from the last corner
      long index = MeshNumbers.index(words.nextToken().split("/", 2)[0]);
      around[i] = index < 0 ? corners + index : index - 1;
    }
    mesh.polygon(around, around.length);
  }
}
