package org.mechservice.mechml.document;

import java.util.List;

/**
 * Writes a document as canonical text: one element a line, two blanks of indentation a level, empty
 * elements as one tag, values in double quotes. Reading that text gives the same document, and a
 * canonical file is written back unchanged.
 *
 * <p>The reader has replaced line breaks inside values by blanks, and entities by their text; the
 * rest of the layout is not kept.
 */
public final class DocumentWriter {
  private static final String INDENT = "  ";

  private final StringBuilder text = new StringBuilder();

  private DocumentWriter() {}

  /** Returns the text of a document. */
  public static String write(Document document) {
    DocumentWriter writer = new DocumentWriter();
    writer.text.append("<?xml version=\"1.0\"?>\n");
    document.systemId().ifPresent(id -> writer.doctype(document.root().name(), id));
    writer.contents(document.prolog(), "");
    writer.element(document.root(), "");
    writer.contents(document.epilog(), "");
    return writer.text.toString();
  }

  private void doctype(String root, String systemId) {
    char quote = systemId.indexOf('"') < 0 ? '"' : '\'';
    text.append("<!DOCTYPE ").append(root).append(" SYSTEM ");
    text.append(quote).append(systemId).append(quote).append(">\n");
  }

  private void contents(List<? extends Content> contents, String indent) {
    for (Content content : contents) {
      if (content instanceof Element element) {
        element(element, indent);
      } else if (content instanceof Comment comment) {
        text.append(indent).append("<!--").append(comment.text()).append("-->\n");
      } else {
        throw new IllegalArgumentException("a model file has no text between tags: " + content);
      }
    }
  }

  private void element(Element element, String indent) {
    text.append(indent).append('<').append(element.name());
    for (Attribute attribute : element.attributes()) {
      text.append(' ').append(attribute.name()).append("=\"");
      value(attribute.value());
      text.append('"');
    }
    if (element.content().isEmpty()) {
      text.append("/>\n");
    } else if (element.content().get(0) instanceof Text inner) {
      // Nothing may stand beside a text. A section cannot hold its own end: two divide that.
      text.append("><![CDATA[").append(inner.text().replace("]]>", "]]]]><![CDATA[>"));
      text.append("]]></").append(element.name()).append(">\n");
    } else {
      text.append(">\n");
      contents(element.content(), indent + INDENT);
      text.append(indent).append("</").append(element.name()).append(">\n");
    }
  }

  /** Replaces markup characters and line breaks by character references. */
  private void value(String value) {
    for (int i = 0; i < value.length(); i++) {
      char c = value.charAt(i);
      switch (c) {
        case '&' -> text.append("&amp;");
        case '<' -> text.append("&lt;");
        case '"' -> text.append("&quot;");
        case '\t', '\n', '\r' -> text.append("&#").append((int) c).append(';');
        default -> text.append(c);
      }
    }
  }
}
