package org.mechservice.view.mesh;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.StringTokenizer;

/** Reads STL, text or binary; normals are left out, they follow from the corners. */
final class StlReader {
  private static final int HEADER = 84;
  private static final int FACET = 50;

  private StlReader() {}

  static Mesh read(byte[] content) throws MeshException {
    // a binary file may begin with "solid" too; its length tells it
    if (content.length >= HEADER) {
      ByteBuffer bytes = ByteBuffer.wrap(content).order(ByteOrder.LITTLE_ENDIAN);
      long facets = Integer.toUnsignedLong(bytes.getInt(HEADER - 4));
      if (HEADER + FACET * facets == content.length) {
        return binary(bytes, facets);
      }
    }
    return text(new String(content, StandardCharsets.US_ASCII));
  }

  private static Mesh binary(ByteBuffer bytes, long facets) throws MeshException {
    MeshBuilder mesh = new MeshBuilder();
    for (int facet = 0; facet < facets; facet++) {
      int at = HEADER + FACET * facet + 12;
      int first = 0;
      for (int i = 0; i < 3; i++, at += 12) {
        first = mesh.corner(bytes.getFloat(at), bytes.getFloat(at + 4), bytes.getFloat(at + 8));
      }
      mesh.triangle(first - 2L, first - 1L, first);
    }
    return mesh.mesh();
  }

  private static Mesh text(String content) throws MeshException {
    StringTokenizer words = new StringTokenizer(content);
    if (!words.hasMoreTokens() || !words.nextToken().equalsIgnoreCase("solid")) {
      throw new MeshException(
          "it is no STL: neither begins it with \"solid\" nor does its length fit a binary one");
    }
    MeshBuilder mesh = new MeshBuilder();
    int inFacet = 0;
    while (words.hasMoreTokens()) {
      String word = words.nextToken();
      if (word.equalsIgnoreCase("loop")) {
        inFacet = 0;
      } else if (word.equalsIgnoreCase("vertex")) {
        long corner = mesh.corner(number(words), number(words), number(words));
        inFacet++;
        if (inFacet == 3) {
          mesh.triangle(corner - 2, corner - 1, corner);
        }
      }
    }
    return mesh.mesh();
  }

  private static double number(StringTokenizer words) throws MeshException {
    return MeshNumbers.number(words.hasMoreTokens() ? words.nextToken() : "");
  }
}
