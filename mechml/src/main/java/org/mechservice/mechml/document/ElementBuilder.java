package org.mechservice.mechml.document;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.diagnosis.SourcePosition;
import org.mechservice.solver.catalogue.MessageCode;
import org.xml.sax.Attributes;
import org.xml.sax.Locator;
import org.xml.sax.SAXException;
import org.xml.sax.ext.DefaultHandler2;

/**
 * Builds the tree of elements from the parser's events.
 *
 * <p>The parser reports the end of each event; a tag begins at the end of the previous event.
 */
final class ElementBuilder extends DefaultHandler2 {
  /** The element that holds the text of another file. */
  private static final String FILE_HOLDER = "included";

  /**
   * An element whose end has not been read.
   *
   * @param head the element without its children
   * @param content the children read so far
   */
  private record Open(Element head, List<Content> content) {
    Element close() {
      return new Element(head.name(), head.attributes(), content, head.position(), head.owner());
    }
  }

  private final Diagnostics diagnostics;
  private final ParserPosition here;
  private final Deque<Open> open = new ArrayDeque<>();
  private final List<Comment> prolog = new ArrayList<>();
  private final List<Comment> epilog = new ArrayList<>();
  private Optional<String> systemId = Optional.empty();
  private Optional<Element> root = Optional.empty();
  private final StringBuilder held = new StringBuilder();
  private boolean inDtd;
  private boolean foreign;
  private final StringBuilder words = new StringBuilder();
  private int elements;
  private int line = 1;
  private int column = 1;

  /**
   * Begins without elements.
   *
   * @param diagnostics receives errors about text between tags
   * @param here the parser's current position
   */
  ElementBuilder(Diagnostics diagnostics, ParserPosition here) {
    this.diagnostics = diagnostics;
    this.here = here;
  }

  /**
   * Returns the document; empty before the end of the outermost element.
   *
   * @param hasDoctype whether the file itself names the grammar
   */
  Optional<Document> document(boolean hasDoctype) {
    return root.map(r -> new Document(systemId.filter(id -> hasDoctype), prolog, r, epilog));
  }

  /** Allows text between tags and refuses a DOCTYPE. */
  void takeForeign() {
    foreign = true;
  }

  /** Returns the innermost element whose end has not been read, without its children. */
  Optional<Element> innermost() {
    return Optional.ofNullable(open.peek()).map(Open::head);
  }

  @Override
  public void setDocumentLocator(Locator locator) {
    here.follow(locator);
  }

  @Override
  public void startElement(String uri, String localName, String name, Attributes attributes)
      throws SAXException {
    if (open.isEmpty()) {
      // The parser reports no event for white space before the outermost element.
      line = here.line();
      column = Math.max(1, here.column() - name.length() - 2);
    }
    keepText();
    List<Attribute> copy = copy(attributes);
    Element head = new Element(name, copy, List.of(), position(name, attributes), owner());
    checkLimits(head);
    open.push(new Open(head, new ArrayList<>()));
    passed();
  }

  private SourcePosition position(String name, Attributes attributes) {
    String parentPath = innermost().map(e -> e.position().path() + "/").orElse("");
    String ownName = attributes.getValue("name");
    String step = ownName == null ? name : name + "[" + ownName + "]";
    return new SourcePosition(line, column, parentPath + Quoted.plain(step));
  }

  private String owner() {
    return innermost().map(Element::ownerOfChildren).orElse("");
  }

  private static List<Attribute> copy(Attributes attributes) {
    List<Attribute> copy = new ArrayList<>(attributes.getLength());
    for (int i = 0; i < attributes.getLength(); i++) {
      copy.add(new Attribute(attributes.getQName(i), attributes.getValue(i)));
    }
    return copy;
  }

  private void checkLimits(Element element) throws RejectedFileException {
    elements++;
    if (elements > Limits.ELEMENTS) {
      throw tooLarge(element, "the file has more than " + Limits.ELEMENTS + " elements");
    }
    int deepest = foreign ? Limits.FOREIGN_DEPTH : Limits.DEPTH;
    if (open.size() >= deepest) {
      throw tooLarge(element, "elements are nested deeper than " + deepest + " levels");
    }
    for (Attribute attribute : element.attributes()) {
      if (attribute.value().length() > Limits.ATTRIBUTE_LENGTH) {
        throw tooLarge(
            element,
            Phrase.of(
                "attribute %s has more than %d characters",
                Quoted.of(attribute.name()), Limits.ATTRIBUTE_LENGTH));
      }
    }
  }

  private static RejectedFileException tooLarge(Element element, String message) {
    return new RejectedFileException(MessageCode.MODEL_FILE_TOO_LARGE, element.position(), message);
  }

  @Override
  public void endElement(String uri, String localName, String name) {
    if (!foreign && name.equals(FILE_HOLDER)) {
      open.element().content().add(new Text(held.toString()));
      held.setLength(0);
    }
    keepText();
    Element element = open.pop().close();
    Open parent = open.peek();
    if (parent == null) {
      root = Optional.of(element);
    } else {
      parent.content().add(element);
    }
    passed();
  }

  @Override
  public void characters(char[] text, int start, int length) {
    Open element = open.peek();
    if (foreign) {
      words.append(text, start, length);
    } else if (element != null && element.head().name().equals(FILE_HOLDER)) {
      held.append(text, start, length);
    } else {
      String content = new String(text, start, length).strip();
      if (!content.isEmpty() && !diagnostics.isFull()) {
        innermost().ifPresent(around -> reportText(around, content));
      }
    }
    passed();
  }

  /** Adds the text since the last tag to the innermost element; the parser gives it in pieces. */
  private void keepText() {
    String content = words.toString().strip();
    words.setLength(0);
    Open element = open.peek();
    if (element != null && !content.isEmpty()) {
      element.content().add(new Text(content));
    }
  }

  private void reportText(Element element, String content) {
    diagnostics.error(
        MessageCode.STRAY_TEXT,
        new SourcePosition(line, column, element.position().path()),
        Phrase.of(
            "%s: text %s is between tags; write values in attributes",
            element.label(), Quoted.of(content)));
  }

  @Override
  public void ignorableWhitespace(char[] text, int start, int length) {
    passed();
  }

  @Override
  public void processingInstruction(String target, String text) {
    passed();
  }

  @Override
  public void startDTD(String name, @Nullable String publicId, @Nullable String dtdId)
      throws SAXException {
    if (foreign) {
      throw new RejectedFileException(
          MessageCode.DOCTYPE_DECLARES, here.position(), "the file has a DOCTYPE; leave it out");
    }
    inDtd = true;
    // Without DOCTYPE the parser announces the bundled grammar with the file's own id, which is
    // none.
    systemId = Optional.ofNullable(dtdId);
  }

  @Override
  public void endDTD() {
    inDtd = false;
  }

  /** {@inheritDoc} Comments inside a DOCTYPE or the DTD are skipped. */
  @Override
  public void comment(char[] text, int start, int length) {
    Comment comment = new Comment(new String(text, start, length));
    if (!inDtd) {
      Open element = open.peek();
      if (element != null) {
        element.content().add(comment);
      } else {
        (root.isEmpty() ? prolog : epilog).add(comment);
      }
    }
    passed();
  }

  @Override
  public void endEntity(String name) {
    passed();
  }

  private void passed() {
    line = here.line();
    column = here.column();
  }
}
