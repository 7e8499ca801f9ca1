package org.mechservice.client;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.mechservice.client.failure.InvalidOptionException;
import org.mechservice.client.failure.RemoteCalls;
import org.mechservice.client.failure.ServerLostException;
import org.mechservice.client.failure.ServiceException;
import org.mechservice.idl.MechServer;
import org.mechservice.orb.ServiceOrb;
import org.mechservice.orb.ServiceUnreachableException;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * The servers that a client may use, in the order of preference, and the one in use. Thread-safe.
 */
final class ServerSelection {
  /**
   * A server that answered.
   *
   * @param index its index among the addresses
   * @param server its object
   * @param calls calls that name its address in messages
   * @param description its description
   */
  record Chosen(int index, MechServer server, RemoteCalls calls, ServiceDescription description) {}

  private final ServiceOrb orb;
  private final List<String> addresses;
  private Chosen chosen;

  /**
   * Connects to the first server that answers.
   *
   * @param written one or more addresses, separated by commas
   * @throws ServerLostException if none answers
   * @throws InvalidOptionException if one is no address
   */
  ServerSelection(ServiceOrb orb, String written) {
    this.orb = orb;
    addresses =
        Arrays.stream(written.split(",", -1)).map(String::strip).filter(s -> !s.isEmpty()).toList();
    if (addresses.isEmpty()) {
      throw new InvalidOptionException(
          MessageCode.SERVER_ADDRESS.code(),
          MessageCode.SERVER_ADDRESS + " \"" + written + "\" names no server; write HOST:PORT",
          "server");
    }
    chosen = firstFrom(0);
  }

  synchronized Chosen chosen() {
    return chosen;
  }

  /**
   * Returns another server in place of a lost one.
   *
   * @param lost exception of the lost server
   * @throws ServerLostException if no other answers
   */
  @SuppressWarnings("ReferenceEquality") // The same server may have been chosen again meanwhile.
  synchronized Chosen instead(Chosen gone, ServerLostException lost) {
    if (addresses.size() == 1) {
      throw lost;
    }
    if (chosen.equals(gone)) {
      chosen = firstFrom(gone.index() + 1);
    }
    return chosen;
  }

  /** Returns the other servers that answer, without changing the server in use. */
  List<Chosen> others(Chosen beside) {
    List<Chosen> others = new ArrayList<>();
    for (int i = 1; i < addresses.size(); i++) {
      answering((beside.index() + i) % addresses.size()).ifPresent(others::add);
    }
    return others;
  }

  private Optional<Chosen> answering(int index) {
    try {
      return Optional.of(connect(index));
    } catch (ServerLostException silent) {
      return Optional.empty();
    }
  }

  private Chosen firstFrom(int start) {
    List<ServerLostException> silent = new ArrayList<>();
    for (int i = 0; i < addresses.size(); i++) {
      int index = (start + i) % addresses.size();
      try {
        return connect(index);
      } catch (ServerLostException e) {
        silent.add(e);
      }
    }
    throw silent.size() == 1 ? silent.get(0) : noneOf(silent);
  }

  private Chosen connect(int index) {
    String address = addresses.get(index);
    try {
      ServiceOrb.Connected found = orb.connectTo(address);
      return new Chosen(
          index, found.server(), new RemoteCalls(address), ServiceDescription.of(found.info()));
    } catch (ServiceUnreachableException e) {
      String text = String.valueOf(e.getMessage());
      throw new ServerLostException(
          ServiceException.codeOf(text, MessageCode.SERVER_UNREACHABLE.code()), text, address);
    } catch (IllegalArgumentException e) {
      String text = String.valueOf(e.getMessage());
      throw new InvalidOptionException(
          ServiceException.codeOf(text, MessageCode.SERVER_UNREACHABLE.code()), text, "server");
    }
  }

  private ServerLostException noneOf(List<ServerLostException> silent) {
    StringBuilder text = new StringBuilder("none of the servers can be used");
    silent.forEach(one -> text.append("; ").append(one.getMessage()));
    return new ServerLostException(
        MessageCode.NO_SERVER_USABLE.code(),
        MessageCode.NO_SERVER_USABLE + " " + text,
        String.join(",", addresses));
  }
}
