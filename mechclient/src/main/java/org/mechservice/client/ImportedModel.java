package org.mechservice.client;

import java.util.List;
import org.mechservice.client.failure.ModelMessage;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * A model of another format, translated by the server.
 *
 * @param text the model in MechML
 * @param messages parts of the file that are not in the model, in file order, then warnings about
 *     the model
 */
public record ImportedModel(String text, List<ModelMessage> messages) {
  private static final String LOSS = MessageCode.ROBOT_LOST.code();

  public ImportedModel {
    messages = List.copyOf(messages);
  }

  /** Returns the number of parts of the file that are not in the model. */
  public int lost() {
    return (int) messages.stream().filter(message -> message.code().equals(LOSS)).count();
  }
}
