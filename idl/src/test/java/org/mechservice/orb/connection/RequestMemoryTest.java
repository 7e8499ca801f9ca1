package org.mechservice.orb.connection;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.junit.jupiter.api.Test;

class RequestMemoryTest {
  private static final int SIZE = 1 << 20;

  private final RequestMemory room = new RequestMemory(SIZE);

  private static byte[] header(int length, ByteOrder order) {
    return ByteBuffer.allocate(12)
        .put(
            new byte[] {
              'G', 'I', 'O', 'P', 1, 2, (byte) (order == ByteOrder.LITTLE_ENDIAN ? 1 : 0)
            })
        .put((byte) 0)
        .order(order)
        .putInt(length)
        .array();
  }

  private RequestStream stream(Socket socket, byte[] bytes) {
    return new RequestStream(socket, new ByteArrayInputStream(bytes), room);
  }

  @Test
  void announcedLengthTakesRoomUntilTheMessageIsThere() throws Exception {
    for (ByteOrder order : new ByteOrder[] {ByteOrder.BIG_ENDIAN, ByteOrder.LITTLE_ENDIAN}) {
      byte[] message = ByteBuffer.allocate(12 + 500_000).put(header(500_000, order)).array();
      try (Socket socket = new Socket()) {
        RequestStream stream = stream(socket, message);
        assertThat(room.used()).isZero();
        assertThat(stream.readNBytes(5)).hasSize(5);
        assertThat(stream.readNBytes(7)).hasSize(7);
        assertThat(room.used()).isEqualTo(500_000);
        assertThat(stream.readNBytes(500_000)).hasSize(500_000);
        assertThat(room.used()).isZero();
      }
    }
  }

  @Test
  void whoAnnouncesMoreThanThereIsRoomForIsRefused() throws Exception {
    try (Socket first = new Socket();
        Socket second = new Socket()) {
      RequestStream large = stream(first, header(SIZE, ByteOrder.BIG_ENDIAN));
      RequestStream larger = stream(second, header(SIZE, ByteOrder.BIG_ENDIAN));
      assertThat(large.readNBytes(12)).hasSize(12);
      assertThatThrownBy(() -> larger.readNBytes(12))
          .isInstanceOf(IOException.class)
          .hasMessageContaining("no room");
      large.ended();
      assertThat(room.used()).isZero();
    }
  }

  /** A fragment of a request of version 1.2, whose id begins its body. */
  private static byte[] fragment(int type, int request, boolean more, int length) {
    byte[] head = header(length, ByteOrder.BIG_ENDIAN);
    head[6] = (byte) (more ? 2 : 0);
    head[7] = (byte) type;
    return ByteBuffer.allocate(12 + length).put(head).putInt(request).array();
  }

  private static byte[] joined(byte[]... parts) {
    ByteArrayOutputStream all = new ByteArrayOutputStream();
    for (byte[] part : parts) {
      all.writeBytes(part);
    }
    return all.toByteArray();
  }

  @Test
  void fragmentsTakeRoomUntilTheLastIsThere() throws Exception {
    byte[] begin = fragment(0, 7, true, 1000);
    byte[] middle = fragment(7, 7, true, 500);
    byte[] ofNothing = fragment(7, 8, false, 100);
    byte[] last = fragment(7, 7, false, 100);
    try (Socket socket = new Socket()) {
      RequestStream stream = stream(socket, joined(begin, middle, ofNothing, last));
      stream.readNBytes(begin.length + middle.length + ofNothing.length);
      assertThat(room.used()).isEqualTo(1500);
      stream.readNBytes(last.length);
      assertThat(room.used()).isZero();
    }
  }

  /** Requests are answered instead. */
  @Test
  void fragmentsOfAReplyTogetherAreNoLargerThanAMessageMayBe() throws Exception {
    RequestMemory large = new RequestMemory(1L << 40);
    int each = LimitedBuffers.MAX_MESSAGE_BYTES / 4;
    byte[] fragment = fragment(7, 7, true, each);
    try (Socket socket = new Socket()) {
      byte[] all = joined(fragment(1, 7, true, each), fragment, fragment, fragment, fragment);
      RequestStream stream = new RequestStream(socket, new ByteArrayInputStream(all), large);
      stream.readNBytes(4 * (12 + each));
      assertThatThrownBy(stream::readAllBytes)
          .isInstanceOf(IOException.class)
          .hasMessageContaining("at most 33554432 bytes in 100 are allowed");
      stream.ended();
      assertThat(large.used()).isZero();
    }
  }

  @Test
  void fragmentsOfAllConnectionsShareTheRoom() throws Exception {
    byte[] half = fragment(0, 7, true, SIZE * 2 / 3);
    try (Socket first = new Socket();
        Socket second = new Socket()) {
      stream(first, half).readAllBytes();
      assertThatThrownBy(() -> stream(second, half).readAllBytes())
          .isInstanceOf(IOException.class)
          .hasMessageContaining("no room");
    }
  }

  private static long in(double seconds) {
    return System.nanoTime() + (long) (seconds * 1e9);
  }

  @Test
  void peerIsLateWithItsFirstMessageOrTheRestOfOneAfterTenSeconds() throws Exception {
    byte[] message = ByteBuffer.allocate(12 + 8).put(header(8, ByteOrder.BIG_ENDIAN)).array();
    try (Socket socket = new Socket()) {
      RequestStream stream = stream(socket, joined(message, message));
      assertThat(stream.isOverdue(in(9))).isFalse();
      assertThat(stream.isOverdue(in(11))).isTrue();
      stream.readNBytes(message.length);
      assertThat(stream.isUsed()).isTrue();
      assertThat(stream.isOverdue(in(1000))).isFalse(); // idle, which the ORB bounds
      stream.readNBytes(15);
      assertThat(stream.isOverdue(in(9))).isFalse();
      assertThat(stream.isOverdue(in(11))).isTrue();
    }
  }

  @Test
  void peerIsLateWithAMissingFragment() throws Exception {
    try (Socket socket = new Socket()) {
      RequestStream stream = stream(socket, fragment(0, 7, true, 100));
      stream.readAllBytes();
      assertThat(stream.isOverdue(in(9))).isFalse();
      assertThat(stream.isOverdue(in(11))).isTrue();
    }
  }

  @Test
  void negativeLengthEndsTheConnection() throws Exception {
    try (Socket socket = new Socket()) {
      RequestStream stream = stream(socket, header(-1, ByteOrder.BIG_ENDIAN));
      assertThatThrownBy(stream::readAllBytes)
          .isInstanceOf(IOException.class)
          .hasMessageContaining("negative");
      assertThat(stream.isUsed()).isFalse();
    }
  }

  @Test
  void requestThatAsksForAnUnknownKindOfAnswerEndsTheConnection() throws Exception {
    byte[] request = fragment(0, 7, false, 100);
    request[16] = 2;
    try (Socket socket = new Socket()) {
      RequestStream stream = stream(socket, request);
      assertThatThrownBy(stream::readAllBytes)
          .isInstanceOf(IOException.class)
          .hasMessageContaining("response flags 2");
    }
  }

  /** The ORB reads each connection in a thread, which dies of some messages. */
  @Test
  void connectionThatNobodyReadsAnyMoreCountsAsLate() throws Exception {
    byte[] message = ByteBuffer.allocate(12 + 8).put(header(8, ByteOrder.BIG_ENDIAN)).array();
    try (Socket socket = new Socket()) {
      RequestStream stream = stream(socket, message);
      Thread reader =
          new Thread(
              () -> {
                try {
                  stream.readNBytes(message.length);
                } catch (IOException e) {
                  throw new java.io.UncheckedIOException(e);
                }
              });
      reader.start();
      reader.join();
      assertThat(stream.isOverdue(in(0))).isTrue();
    }
  }

  @Test
  void noiseIsNoMessage() throws Exception {
    try (Socket socket = new Socket()) {
      RequestStream stream = stream(socket, new byte[100]);
      stream.readAllBytes();
      assertThat(stream.isUsed()).isFalse();
      assertThat(stream.isOverdue(in(11))).isTrue();
    }
  }

  @Test
  void smallMessagesNeedNoRoom() throws Exception {
    try (Socket socket = new Socket()) {
      assertThat(stream(socket, header(1000, ByteOrder.BIG_ENDIAN)).readNBytes(12)).hasSize(12);
      assertThat(room.used()).isZero();
    }
  }
}
