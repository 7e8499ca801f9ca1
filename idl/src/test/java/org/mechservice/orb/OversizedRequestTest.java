package org.mechservice.orb;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Requests above the largest size, as ORBs of other languages send them: each gets an answer that
 * says what is allowed, and its connection goes on.
 */
class OversizedRequestTest {
  private static final int SIZE = 50 << 20;
  private static final int REQUEST = 0;
  private static final int FRAGMENT = 7;
  private static final int MORE = 2;
  private static final int INVOCATION_POLICIES = 7;
  private static final int USER_EXCEPTION = 1;
  private static final int SYSTEM_EXCEPTION = 2;

  private static byte[] header(int type, int flags, int length) {
    return ByteBuffer.allocate(12)
        .put(new byte[] {'G', 'I', 'O', 'P', 1, 2, (byte) flags, (byte) type})
        .putInt(length)
        .array();
  }

  /** The body of a request of version 1.2 up to its arguments (OMG, CORBA 3.0, section 15.4.2). */
  private static byte[] whatIsAsked(int id, String operation) {
    byte[] key = "MechServer".getBytes(StandardCharsets.US_ASCII);
    byte[] name = (operation + '\0').getBytes(StandardCharsets.US_ASCII);
    ByteBuffer body = ByteBuffer.allocate(200);
    body.putInt(id).put(new byte[] {3, 0, 0, 0}); // an answer is expected
    body.putShort((short) 0).putShort((short) 0).putInt(key.length).put(key);
    align(body, 4);
    body.putInt(name.length).put(name);
    align(body, 4);
    body.putInt(0); // no service contexts
    align(body, 8);
    return Arrays.copyOf(body.array(), body.position());
  }

  private static void align(ByteBuffer body, int size) {
    while ((12 + body.position()) % size != 0) {
      body.put((byte) 0);
    }
  }

  private static void sendWhole(OutputStream out, int id, String operation) throws IOException {
    byte[] asked = whatIsAsked(id, operation);
    out.write(header(REQUEST, 0, SIZE));
    out.write(asked);
    out.write(new byte[SIZE - asked.length]);
  }

  private static void sendInFragments(OutputStream out, int id, String operation)
      throws IOException {
    byte[] asked = whatIsAsked(id, operation);
    out.write(header(REQUEST, MORE, asked.length));
    out.write(asked);
    int each = 1 << 20;
    for (int sent = 0; sent < SIZE; sent += each) {
      ByteArrayOutputStream fragment = new ByteArrayOutputStream(each + 12);
      fragment.writeBytes(header(FRAGMENT, sent + each < SIZE ? MORE : 0, each));
      fragment.writeBytes(ByteBuffer.allocate(each).putInt(id).array());
      fragment.writeTo(out);
    }
  }

  /** An answer: which request it belongs to, what kind it is, and its text. */
  private record Answer(int request, int status, String text) {}

  private static Answer answer(Socket socket) throws IOException {
    DataInputStream in = new DataInputStream(socket.getInputStream());
    byte[] header = in.readNBytes(12);
    assertThat(header).hasSize(12);
    byte[] body = in.readNBytes(ByteBuffer.wrap(header).getInt(8));
    ByteBuffer fields = ByteBuffer.wrap(body);
    return new Answer(
        fields.getInt(), fields.getInt(), new String(body, StandardCharsets.ISO_8859_1));
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void requestThatIsTooLargeIsAnsweredAndTheConnectionGoesOn(boolean fragments) throws Exception {
    try (EchoServer server = EchoServer.start();
        Socket socket = new Socket(InetAddress.getLoopbackAddress(), server.port())) {
      OutputStream out = socket.getOutputStream();
      for (int id = 1; id < 3; id++) {
        if (fragments) {
          sendInFragments(out, id, "importModel");
        } else {
          sendWhole(out, id, "importModel");
        }
        Answer answer = answer(socket);
        assertThat(answer.request()).isEqualTo(id);
        assertThat(answer.status()).isEqualTo(USER_EXCEPTION);
        assertThat(answer.text())
            .contains("IDL:mechservice.org/mechservice/LimitExceeded:1.0")
            .contains("S-105")
            .contains("importModel was sent at least ")
            .contains("this server takes at most 33554432 in one request");
      }
      byte[] small = whatIsAsked(9, "limits");
      out.write(header(REQUEST, 0, small.length));
      out.write(small);
      assertThat(answer(socket).status()).isZero();
    }
  }

  /** The ORB looks for a time in the context and finds nothing; its reader dies of that. */
  @Test
  void requestWithAContextThatIsNoneEndsItsConnection() throws Exception {
    byte[] asked = whatIsAsked(1, "getInfo");
    byte[] broken = Arrays.copyOf(asked, asked.length + 8);
    int contexts = endOfName(asked);
    ByteBuffer.wrap(broken)
        .putInt(contexts, 1)
        .putInt(contexts + 4, INVOCATION_POLICIES)
        .putInt(contexts + 8, 0);
    try (EchoServer server = EchoServer.start();
        Socket socket = new Socket(InetAddress.getLoopbackAddress(), server.port());
        ServiceOrb client = ServiceOrb.client()) {
      socket.setSoTimeout(10_000);
      socket.getOutputStream().write(header(REQUEST, 0, broken.length));
      socket.getOutputStream().write(broken);
      assertThat(socket.getInputStream().read()).isEqualTo(-1);
      assertThat(client.connect(server.address()).getInfo().serverName).isEqualTo("echo €");
    }
  }

  /** Returns where the number of service contexts stands. */
  private static int endOfName(byte[] asked) {
    String text = new String(asked, StandardCharsets.ISO_8859_1);
    int end = text.indexOf("getInfo") + "getInfo".length() + 1;
    return end + (4 - (12 + end) % 4) % 4;
  }

  @Test
  void operationWithoutLimitsAnswersWithTheOrbsOwnException() throws Exception {
    try (EchoServer server = EchoServer.start();
        Socket socket = new Socket(InetAddress.getLoopbackAddress(), server.port())) {
      sendWhole(socket.getOutputStream(), 1, "getInfo");
      Answer answer = answer(socket);
      assertThat(answer.status()).isEqualTo(SYSTEM_EXCEPTION);
      assertThat(answer.text()).contains("IMP_LIMIT");
    }
  }
}
