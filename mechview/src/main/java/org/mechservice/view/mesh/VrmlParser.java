package org.mechservice.view.mesh;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Reads the text of VRML 97 (ISO/IEC 14772-1) into nodes, whatever their types. Fields of text and
 * truth values are read and dropped; prototypes are refused.
 */
final class VrmlParser {
  private static final int DEEPEST = 100;
  private static final String END = "";

  private final String text;
  private final Map<String, VrmlNode> named = new HashMap<>();
  private int at;
  private String word;

  VrmlParser(byte[] content) throws MeshException {
    text = new String(content, StandardCharsets.UTF_8);
    if (!text.startsWith("#VRML V2.0 utf8")) {
      throw new MeshException(
          text.startsWith("#VRML V1.0")
              ? "it is VRML 1.0; save it as VRML 97 (#VRML V2.0 utf8)"
              : "it does not begin with #VRML V2.0 utf8");
    }
    word = next();
  }

  /** Returns the nodes at the top of the file. */
  List<VrmlNode> file() throws MeshException {
    List<VrmlNode> nodes = new ArrayList<>();
    while (!word.equals(END)) {
      if (word.equals("ROUTE")) {
        skipRoute();
      } else {
        nodes.add(node(0));
      }
    }
    return nodes;
  }

  private void skipRoute() throws MeshException {
    for (int i = 0; i < 4; i++) {
      take();
    }
  }

  private VrmlNode node(int depth) throws MeshException {
    if (depth > DEEPEST) {
      throw wrong("nodes lie in each other more than " + DEEPEST + " deep");
    }
    String first = take();
    if (first.equals("USE")) {
      String name = take();
      VrmlNode known = named.get(name);
      if (known == null) {
        throw wrong("USE " + MeshNumbers.quoted(name) + " comes before its DEF");
      }
      return known;
    }
    String name = END;
    if (first.equals("DEF")) {
      name = take();
      first = take();
    }
    if (first.equals("PROTO") || first.equals("EXTERNPROTO") || first.equals("Script")) {
      throw wrong(first + " is not supported; save the file without prototypes and scripts");
    }
    VrmlNode node = new VrmlNode(first);
    require("{");
    while (!word.equals("}")) {
      if (word.equals("ROUTE")) {
        skipRoute();
      } else {
        field(node, take(), depth);
      }
    }
    take();
    // after its end: a node is not inside itself
    named.put(name, node);
    return node;
  }

  private void field(VrmlNode node, String field, int depth) throws MeshException {
    if (word.equals("[")) {
      take();
      if (isNumber(word)) {
        node.put(field, numbers());
      } else {
        while (!word.equals("]")) {
          value(node, field, depth);
        }
      }
      require("]");
    } else if (isNumber(word)) {
      node.put(field, numbers());
    } else {
      value(node, field, depth);
    }
  }

  private void value(VrmlNode node, String field, int depth) throws MeshException {
    if (word.startsWith("\"")
        || word.equals("TRUE")
        || word.equals("FALSE")
        || word.equals("NULL")) {
      take();
    } else {
      node.add(field, node(depth + 1));
    }
  }

  private static boolean isNumber(String word) {
    char c = word.isEmpty() ? ' ' : word.charAt(0);
    return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.';
  }

  private double[] numbers() throws MeshException {
    double[] values = new double[8];
    int count = 0;
    while (isNumber(word)) {
      if (count == values.length) {
        values = Arrays.copyOf(values, 2 * count);
      }
      values[count] = MeshNumbers.number(take());
      count++;
    }
    return Arrays.copyOf(values, count);
  }

  private void require(String wanted) throws MeshException {
    String found = take();
    if (!found.equals(wanted)) {
      throw wrong(MeshNumbers.quoted(found) + " stands where " + wanted + " is due");
    }
  }

  private String take() throws MeshException {
    if (word.equals(END)) {
      throw wrong("the file ends inside a node");
    }
    String taken = word;
    word = next();
    return taken;
  }

  private MeshException wrong(String what) {
    long line =
        text.substring(0, Math.min(at, text.length())).chars().filter(c -> c == '\n').count();
    return new MeshException("line " + (line + 1) + ": " + what);
  }

  private String next() {
    while (at < text.length()) {
      char c = text.charAt(at);
      if (c == '#') {
        int end = text.indexOf('\n', at);
        at = end < 0 ? text.length() : end;
      } else if (c <= ' ' || c == ',') {
        at++;
      } else {
        return wordAt(c);
      }
    }
    return END;
  }

  private String wordAt(char c) {
    int from = at;
    at++;
    if (c == '"') {
      while (at < text.length() && text.charAt(at) != '"') {
        at += text.charAt(at) == '\\' ? 2 : 1;
      }
      at = Math.min(at + 1, text.length());
    } else if ("{}[]".indexOf(c) < 0) {
      while (at < text.length() && !endsWord(text.charAt(at))) {
        at++;
      }
    }
    return text.substring(from, at);
  }

  private static boolean endsWord(char c) {
    return c <= ' ' || ",{}[]#\"".indexOf(c) >= 0;
  }
}
