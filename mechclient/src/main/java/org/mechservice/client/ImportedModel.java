package org.mechservice.client;

import java.util.List;

/**
 * A model of another format, translated by the server.
 *
 * @param text the model in MechML
 * @param losses what of the file is not in it, in file order
 */
public record ImportedModel(String text, List<ModelMessage> losses) {
  public ImportedModel {
    losses = List.copyOf(losses);
  }
}
