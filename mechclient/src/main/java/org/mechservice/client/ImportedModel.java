package org.mechservice.client;

import java.util.List;
import org.mechservice.client.failure.ModelMessage;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * A model of another format, translated by the server.
 *
 * @param text the model in MechML
 * @param messages what of the file is not in it, in file order, then what looks odd in the model
 */
public record ImportedModel(String text, List<ModelMessage> messages) {
  private static final String LOSS = MessageCode.URDF_LOST.code();

  public ImportedModel {
    messages = List.copyOf(messages);
  }

  /** Returns how many things of the file are not in the model. */
  public int lost() {
    return (int) messages.stream().filter(message -> message.code().equals(LOSS)).count();
  }
}
