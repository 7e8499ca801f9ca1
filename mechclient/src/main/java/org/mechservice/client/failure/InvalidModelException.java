package org.mechservice.client.failure;

import java.util.List;
import java.util.stream.Collectors;

/** The server cannot use the model; carries all its messages. */
public final class InvalidModelException extends ServiceException {
  private static final long serialVersionUID = 1L;

  private final transient List<ModelMessage> messages;

  public InvalidModelException(String code, String text, List<ModelMessage> messages) {
    super(code, messages.isEmpty() ? coded(code, text) : joined(messages));
    this.messages = List.copyOf(messages);
  }

  private static String joined(List<ModelMessage> messages) {
    return messages.stream().map(ModelMessage::toString).collect(Collectors.joining("\n"));
  }

  /** Returns the messages of the server, in the order of the file; empty if it gave only a text. */
  public List<ModelMessage> messages() {
    return messages;
  }
}
