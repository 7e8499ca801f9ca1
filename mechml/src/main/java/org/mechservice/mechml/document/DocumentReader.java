package org.mechservice.mechml.document;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.apache.xerces.parsers.DTDConfiguration;
import org.apache.xerces.parsers.SAXParser;
import org.apache.xerces.util.SecurityManager;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.diagnosis.SourcePosition;
import org.mechservice.solver.catalogue.MessageCode;
import org.xml.sax.InputSource;
import org.xml.sax.SAXException;

/** Reads a model file into a tree of elements and checks it against the grammar. */
public final class DocumentReader {
  /** Outermost elements of the formats that {@code mech import} reads. */
  private static final Map<String, String> ROBOTS =
      Map.of("robot", "URDF", "sdf", "SDF", "mujoco", "MJCF");

  private static final String VALIDATION = "http://xml.org/sax/features/validation";
  private static final String NAMESPACES = "http://xml.org/sax/features/namespaces";
  private static final String SECURITY = "http://apache.org/xml/properties/security-manager";
  private static final String LEXICAL = "http://xml.org/sax/properties/lexical-handler";
  private static final String DECLARATIONS = "http://xml.org/sax/properties/declaration-handler";
  private static final String ROOT = "MechML";

  private final String rootName;
  private final Diagnostics diagnostics;
  private final ParserPosition here = new ParserPosition();
  private final BundledDtd dtd = new BundledDtd(here);
  private final GrammarReader grammarReader = new GrammarReader(dtd, here);
  private final ElementBuilder builder;
  private final ParserErrors errors;

  private DocumentReader(String rootName, Diagnostics diagnostics) {
    this.rootName = rootName;
    this.diagnostics = diagnostics;
    this.builder = new ElementBuilder(diagnostics, here);
    this.errors = new ParserErrors(builder);
  }

  /**
   * Reads a file.
   *
   * @param content the file's bytes; not modified
   * @param diagnostics receives errors and warnings
   * @return the document, which is valid
   * @throws MechmlException if the file is too large, not well-formed or not valid
   */
  public static Document read(byte[] content, Diagnostics diagnostics) throws MechmlException {
    return new DocumentReader(ROOT, diagnostics).read(content);
  }

  /**
   * Reads a file that a model includes.
   *
   * @param content the file's bytes; not modified
   * @param diagnostics receives errors and warnings
   * @return its outermost element, {@code subsystem}, which is valid
   * @throws MechmlException if the file is too large, not well-formed or not valid
   */
  public static Element readSubsystem(byte[] content, Diagnostics diagnostics)
      throws MechmlException {
    return new DocumentReader("subsystem", diagnostics).read(content).root();
  }

  /**
   * Reads an XML file of another language without checking a grammar. The file may have no DOCTYPE
   * and hence no entities.
   *
   * @param content the file's bytes; not modified
   * @param diagnostics receives errors and warnings
   * @return the outermost element
   * @throws MechmlException if the file is too large, not well-formed, or has a DOCTYPE
   */
  public static Element readForeign(byte[] content, Diagnostics diagnostics)
      throws MechmlException {
    DocumentReader reader = new DocumentReader(ROOT, diagnostics);
    reader.builder.takeForeign();
    return reader.read(content, false).root();
  }

  /** Returns the grammar of MechML, as the parser reports the declarations of the bundled DTD. */
  static Grammar grammar() {
    DocumentReader reader = new DocumentReader(ROOT, new Diagnostics("mechml.dtd"));
    try {
      reader.parse("<MechML/>".getBytes(StandardCharsets.UTF_8), true);
    } catch (SAXException | IOException e) {
      throw new IllegalStateException("the bundled grammar cannot be read", e);
    }
    return reader.grammarReader.grammar();
  }

  private Document read(byte[] content) throws MechmlException {
    Document document = read(content, true);
    explainInvalidity(document.root());
    diagnostics.throwIfErrors();
    return document;
  }

  private Document read(byte[] content, boolean own) throws MechmlException {
    Optional<Document> document = Optional.empty();
    try {
      document = parse(content, own);
    } catch (RejectedFileException refusal) {
      diagnostics.error(refusal.code(), refusal.position(), refusal.text());
    } catch (SAXException | RuntimeException e) {
      // Xerces throws other runtime exceptions for a few invalid byte sequences.
      diagnostics.error(MessageCode.NOT_WELL_FORMED, here.position(), "this cannot be read as XML");
    } catch (IOException e) {
      diagnostics.error(
          MessageCode.UNREADABLE_TEXT,
          here.position(),
          "the file is not in the encoding that it declares (UTF-8 by default); save it as UTF-8");
    }
    if (document.isEmpty()) {
      diagnostics.throwIfErrors();
    }
    return document.orElseThrow();
  }

  private Optional<Document> parse(byte[] content, boolean own) throws SAXException, IOException {
    if (content.length > Limits.BYTES) {
      throw new RejectedFileException(
          MessageCode.MODEL_FILE_TOO_LARGE,
          SourcePosition.FILE,
          Phrase.of("the file has %d bytes; %d are allowed", content.length, Limits.BYTES));
    }
    parser(own).parse(new InputSource(new ByteArrayInputStream(content)));
    return builder.document(!dtd.isUnasked());
  }

  /** The parser's classes are named here, so that no system property can replace them. */
  private SAXParser parser(boolean own) throws SAXException {
    DTDConfiguration configuration = new DTDConfiguration();
    configuration.setErrorHandler(errors);
    SAXParser parser = new SAXParser(configuration);
    parser.setLocale(Locale.ENGLISH);
    parser.setFeature(VALIDATION, own);
    parser.setFeature(NAMESPACES, false);
    SecurityManager limits = new SecurityManager();
    limits.setEntityExpansionLimit(Limits.ENTITY_REFERENCES);
    parser.setProperty(SECURITY, limits);
    parser.setProperty(LEXICAL, builder);
    parser.setContentHandler(builder);
    if (own) {
      parser.setProperty(DECLARATIONS, grammarReader);
      parser.setEntityResolver(dtd);
    }
    return parser;
  }

  private void explainInvalidity(Element root) {
    if (!root.name().equals(rootName)) {
      diagnostics.error(
          MessageCode.UNKNOWN_ELEMENT,
          root.position(),
          Phrase.of(
              "the outermost element is <%s>; that of %s is <%s>%s",
              Quoted.plain(root.name()),
              rootName.equals(ROOT) ? "a model file" : "an included file",
              rootName,
              ROBOTS.containsKey(root.name())
                  ? ". This is a robot in "
                      + ROBOTS.get(root.name())
                      + "; mech import translates it: mech import ROBOT -o MODEL.xml"
                  : ""));
      return;
    }
    if (errors.invalidity().isPresent()) {
      new GrammarCheck(grammarReader.grammar(), diagnostics).check(root);
    }
    if (!diagnostics.hasErrors()) {
      errors
          .invalidity()
          .ifPresent(i -> diagnostics.error(MessageCode.INVALID_DOCUMENT, i.position(), i.text()));
    }
  }
}
