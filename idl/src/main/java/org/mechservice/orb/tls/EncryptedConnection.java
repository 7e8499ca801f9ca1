package org.mechservice.orb.tls;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.net.SocketException;
import javax.net.ssl.SSLSession;
import javax.net.ssl.SSLSocket;

/**
 * An inbound encrypted connection whose decrypted messages are watched. The ORB uses it as an
 * ordinary socket.
 */
final class EncryptedConnection extends Socket {
  private final Socket accepted;
  private final SSLSocket encrypted;
  private final InputStream messages;
  private final TlsIdentity owner;

  /**
   * @param owner identity of this process
   * @param accepted the connection, as the port has accepted it
   * @param encrypted reads from and writes to the connection
   * @param messages what it reads, watched
   */
  EncryptedConnection(
      TlsIdentity owner, Socket accepted, SSLSocket encrypted, InputStream messages) {
    this.owner = owner;
    this.accepted = accepted;
    this.encrypted = encrypted;
    this.messages = messages;
  }

  TlsIdentity owner() {
    return owner;
  }

  Socket accepted() {
    return accepted;
  }

  /** Returns what the two sides have agreed on; waits for it. */
  SSLSession session() {
    return encrypted.getSession();
  }

  @Override
  public InputStream getInputStream() {
    return messages;
  }

  @Override
  public OutputStream getOutputStream() throws IOException {
    return encrypted.getOutputStream();
  }

  @Override
  public InetAddress getInetAddress() {
    return encrypted.getInetAddress();
  }

  @Override
  public int getPort() {
    return encrypted.getPort();
  }

  @Override
  public InetAddress getLocalAddress() {
    return encrypted.getLocalAddress();
  }

  @Override
  public int getLocalPort() {
    return encrypted.getLocalPort();
  }

  @Override
  @SuppressWarnings("UnsynchronizedOverridesSynchronized") // the socket within has its own lock
  public void setSoTimeout(int millis) throws SocketException {
    encrypted.setSoTimeout(millis);
  }

  @Override
  @SuppressWarnings("UnsynchronizedOverridesSynchronized") // the socket within has its own lock
  public int getSoTimeout() throws SocketException {
    return encrypted.getSoTimeout();
  }

  @Override
  public boolean isConnected() {
    return encrypted.isConnected();
  }

  @Override
  public boolean isClosed() {
    return encrypted.isClosed();
  }

  /** Does nothing: TLS says at its end that nothing more comes. */
  @Override
  public void shutdownOutput() {}

  @Override
  @SuppressWarnings("UnsynchronizedOverridesSynchronized") // must not wait for a thread that reads
  public void close() throws IOException {
    encrypted.close();
  }
}
