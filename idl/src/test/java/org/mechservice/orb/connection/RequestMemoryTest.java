package org.mechservice.orb.connection;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
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
        assertThat(stream.readNBytes(5)).hasSize(5);
        assertThat(room.used()).isZero();
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

  @Test
  void smallMessagesNeedNoRoom() throws Exception {
    try (Socket socket = new Socket()) {
      assertThat(stream(socket, header(1000, ByteOrder.BIG_ENDIAN)).readNBytes(12)).hasSize(12);
      assertThat(room.used()).isZero();
    }
  }
}
