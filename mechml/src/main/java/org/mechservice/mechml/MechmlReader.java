package org.mechservice.mechml;

import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.document.DocumentReader;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.ModelResolver;

/** Reads MechML files. */
public final class MechmlReader {
  private MechmlReader() {}

  /**
   * Reads, validates and resolves a model file. Nothing else is opened or fetched: the DTD is the
   * bundled one.
   *
   * @param fileName name for messages
   * @param content the file's bytes; not modified
   * @return the model
   * @throws MechmlException if the file is not well-formed, not valid, or not a mechanism this
   *     version can hold
   */
  public static MechmlModel read(String fileName, byte[] content) throws MechmlException {
    Diagnostics diagnostics = new Diagnostics(fileName);
    Element document = DocumentReader.read(content, diagnostics);
    return ModelResolver.resolve(document, diagnostics);
  }
}
