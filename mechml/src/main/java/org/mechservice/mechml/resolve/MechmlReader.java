package org.mechservice.mechml.resolve;

import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.ReadOptions;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.document.Document;
import org.mechservice.mechml.document.DocumentReader;

/** Reads MechML files. */
public final class MechmlReader {
  private MechmlReader() {}

  /**
   * Reads, validates and resolves a model file as it is.
   *
   * @see #read(String, byte[], ReadOptions)
   */
  public static MechmlModel read(String fileName, byte[] content) throws MechmlException {
    return read(fileName, content, ReadOptions.NONE);
  }

  /**
   * Reads, validates and resolves a model file. Nothing else is opened or fetched: the DTD is the
   * bundled one.
   *
   * @param fileName name for messages
   * @param content the file's bytes; not modified
   * @param options which simulation is wanted, which parameters are set
   * @return the model
   * @throws MechmlException if the file is not well-formed, not valid, or not a mechanism, or the
   *     options name what it does not have
   */
  public static MechmlModel read(String fileName, byte[] content, ReadOptions options)
      throws MechmlException {
    Diagnostics diagnostics = new Diagnostics(fileName);
    Document document = DocumentReader.read(content, diagnostics);
    return ModelResolver.resolve(document.root(), options, diagnostics);
  }

  /**
   * Reads and validates a model file, and resolves nothing: {@link
   * org.mechservice.mechml.document.DocumentWriter} writes it again.
   *
   * @param fileName name for messages
   * @param content the file's bytes; not modified
   * @throws MechmlException if the file is not well-formed or not valid
   */
  public static Document document(String fileName, byte[] content) throws MechmlException {
    return DocumentReader.read(content, new Diagnostics(fileName));
  }
}
