package org.mechservice.mechml.document;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import org.jspecify.annotations.Nullable;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.solver.catalogue.MessageCode;
import org.xml.sax.InputSource;
import org.xml.sax.SAXException;
import org.xml.sax.ext.EntityResolver2;

/** Gives the XML parser the bundled DTD and refuses every other file. */
final class BundledDtd implements EntityResolver2 {
  private static final String FILE = "mechml.dtd";
  private static final byte[] TEXT = load();

  private final ParserPosition here;
  private boolean served;
  private boolean unasked;

  BundledDtd(ParserPosition here) {
    this.here = here;
  }

  private static byte[] load() {
    try (InputStream stream =
        BundledDtd.class.getResourceAsStream("/org/mechservice/mechml/" + FILE)) {
      if (stream == null) {
        throw new IllegalStateException(FILE + " is missing from the library");
      }
      return stream.readAllBytes();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  static String text() {
    return new String(TEXT, StandardCharsets.UTF_8);
  }

  /** Returns whether the parser has read the DTD. */
  boolean isServed() {
    return served;
  }

  /** Returns whether the file has no DOCTYPE. */
  boolean isUnasked() {
    return unasked;
  }

  /** {@inheritDoc} A file without DOCTYPE is checked, too. */
  @Override
  public InputSource getExternalSubset(String name, @Nullable String baseUri) {
    unasked = true;
    return serve();
  }

  /**
   * {@inheritDoc}
   *
   * @throws SAXException if the file is not the DTD of MechML
   */
  @Override
  public InputSource resolveEntity(
      @Nullable String name, @Nullable String publicId, @Nullable String baseUri, String systemId)
      throws SAXException {
    if (!"[dtd]".equals(name) || !systemId.toLowerCase(Locale.ROOT).endsWith(FILE)) {
      throw new RejectedFileException(
          MessageCode.REFERS_TO_OTHER_FILE,
          here.position(),
          Phrase.of(
              "the file refers to %s; only \"MechML.dtd\" is permitted, and no file is read",
              Quoted.of(systemId)));
    }
    return serve();
  }

  @Override
  public InputSource resolveEntity(@Nullable String publicId, String systemId) throws SAXException {
    return resolveEntity(null, publicId, null, systemId);
  }

  private InputSource serve() {
    served = true;
    InputSource source = new InputSource(new ByteArrayInputStream(TEXT));
    source.setSystemId(FILE);
    return source;
  }
}
