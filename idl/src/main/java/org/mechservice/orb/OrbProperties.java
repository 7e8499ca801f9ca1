package org.mechservice.orb;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.util.Properties;
import java.util.concurrent.ThreadLocalRandom;
import org.jacorb.orb.giop.BiDirConnectionInitializer;
import org.mechservice.orb.connection.ConnectionTableInstaller;
import org.mechservice.orb.connection.InboundSocketFactory;
import org.mechservice.orb.connection.LimitedBuffers;
import org.mechservice.orb.connection.OutboundSocketFactory;
import org.mechservice.orb.tls.CallerInterceptor;
import org.mechservice.orb.tls.TlsInboundSocketFactory;
import org.mechservice.orb.tls.TlsOutboundSocketFactory;

/** The ORB's properties for each role; each line has its reason. */
final class OrbProperties {
  /** Adapter that holds the objects found by name. */
  static final String SERVICE_POA = "Service";

  private static final String SERVER_NAME = "MechServer";
  private static final String CONNECT_TIMEOUT_MILLIS = "5000";
  private static final String WRITE_TIMEOUT_MILLIS = "15000";
  // Long enough that a lease renewed in time keeps its connection; short enough that connections
  // that send half a message and fall silent do not fill the server.
  private static final String IDLE_TIMEOUT_MILLIS = "300000";

  // CORBA's security options, hexadecimal: 20 for trust in the target, 40 for trust in the client.
  private static final String ENCRYPTED = "20";
  private static final String MUTUAL = "60";

  /**
   * Where the ORB seeks a file of its own settings; else in the working folder, where a model may
   * have come with one. Those of the user's home and of Java stay.
   */
  private static final String SETTINGS_FOLDER = "jacorb.config.dir";

  private static final String NO_SETTINGS = System.getProperty("java.home");

  static {
    // The ORB that makes type codes takes no properties.
    if (System.getProperty(SETTINGS_FOLDER) == null) {
      System.setProperty(SETTINGS_FOLDER, NO_SETTINGS);
    }
  }

  private OrbProperties() {}

  /** Properties of a client: it connects to any address and serves callbacks only. */
  static Properties client(Peers peers) {
    Properties properties = common(peers);
    peers.tls().ifPresent(tls -> encrypt(properties, 0));
    // The server finds the way back to a client by the address the client claims to listen on, so
    // two clients must not claim the same one.
    properties.setProperty("OAIAddr", privateLoopbackAddress());
    // A compilation may wait its turn on a busy server.
    properties.setProperty("jacorb.connection.client.pending_reply_timeout", "120000");
    properties.setProperty("jacorb.poa.thread_pool_min", "1");
    properties.setProperty("jacorb.poa.thread_pool_max", "4");
    properties.setProperty("jacorb.poa.queue_max", "1000");
    return properties;
  }

  /** Properties of a server. */
  static Properties server(ListenAddress address, Peers peers) {
    Properties properties = listening(address, peers);
    properties.setProperty("jacorb.implname", SERVER_NAME);
    for (ServiceKey key : ServiceKey.values()) {
      properties.setProperty(
          "jacorb.orb.objectKeyMap." + key.key(),
          SERVER_NAME + "/" + SERVICE_POA + "/" + key.key());
    }
    return properties;
  }

  /**
   * Properties of a host. It has no name of its own: the ORB takes references with its own name for
   * local ones, also those of another process.
   */
  static Properties host(ListenAddress address, Peers peers) {
    return listening(address, peers);
  }

  private static Properties listening(ListenAddress address, Peers peers) {
    Properties properties = common(peers);
    properties.setProperty("OAIAddr", address.host());
    if (peers.tls().isPresent()) {
      encrypt(properties, address.port());
    } else {
      properties.setProperty("OAPort", Integer.toString(address.port()));
    }
    properties.setProperty("jacorb.connection.client.pending_reply_timeout", "5000");
    // Each connection has a thread that reads; how many there may be is up to InboundConnections.
    properties.setProperty("jacorb.connection.server.max_receptor_threads", "100000");
    properties.setProperty("jacorb.connection.server.timeout", IDLE_TIMEOUT_MILLIS);
    // As many calls may wait for rows or events at once; a thread ends when it is not needed.
    properties.setProperty("jacorb.poa.thread_pool_max", "1000");
    properties.setProperty("jacorb.poa.queue_max", "1000");
    return properties;
  }

  private static Properties common(Peers peers) {
    Properties properties = new Properties();
    properties.setProperty("org.omg.CORBA.ORBClass", org.jacorb.orb.ORB.class.getName());
    properties.setProperty(
        "org.omg.CORBA.ORBSingletonClass", org.jacorb.orb.ORBSingleton.class.getName());
    properties.setProperty(SETTINGS_FOLDER, NO_SETTINGS);
    properties.setProperty("jacorb.orb.print_version", "off");
    properties.setProperty("jacorb.log.default.verbosity", "2");
    // Otherwise it follows the JVM's default encoding.
    properties.setProperty("jacorb.native_char_codeset", "utf8");
    // Callbacks come over the client's own connection.
    properties.setProperty(
        "org.omg.PortableInterceptor.ORBInitializerClass.bidir_init",
        BiDirConnectionInitializer.class.getName());
    properties.setProperty(
        "org.omg.PortableInterceptor.ORBInitializerClass.connection_table",
        ConnectionTableInstaller.class.getName());
    properties.setProperty("jacorb.orb_initializer.fail_on_error", "on");
    // The in-process short cut breaks callbacks between two ORBs of one JVM.
    properties.setProperty("jacorb.iiop.enable_loopback", "off");
    properties.setProperty("jacorb.retries", "0");
    // A full queue makes the sender wait; it never drops a call.
    properties.setProperty("jacorb.poa.queue_wait", "on");
    properties.setProperty("jacorb.connection.client.connect_timeout", CONNECT_TIMEOUT_MILLIS);
    properties.setProperty("jacorb.connection.request.write_timeout", WRITE_TIMEOUT_MILLIS);
    properties.setProperty("jacorb.connection.reply.write_timeout", WRITE_TIMEOUT_MILLIS);
    properties.setProperty("jacorb.buffermanager.factory", LimitedBuffers.class.getName());
    properties.setProperty("jacorb.net.socket_factory", OutboundSocketFactory.class.getName());
    properties.setProperty(OutboundSocketFactory.LIST_PROPERTY, peers.outbound().id());
    properties.setProperty(
        "jacorb.net.server_socket_factory", InboundSocketFactory.class.getName());
    properties.setProperty(InboundSocketFactory.CONNECTIONS_PROPERTY, peers.inbound().id());
    properties.setProperty(
        "org.omg.PortableInterceptor.ORBInitializerClass.caller",
        CallerInterceptor.class.getName());
    peers
        .tls()
        .ifPresent(
            tls -> properties.setProperty(TlsOutboundSocketFactory.PEERS_PROPERTY, tls.id()));
    return properties;
  }

  /**
   * Restricts an ORB to TLS, and to calls from callers with a certificate. The ORB writes the
   * options into its references; what it does is up to its socket factories.
   *
   * @param port where it listens; 0: on any free port
   */
  private static void encrypt(Properties properties, int port) {
    properties.setProperty("OASSLPort", Integer.toString(port));
    properties.setProperty("jacorb.security.support_ssl", "on");
    properties.setProperty("jacorb.ssl.socket_factory", TlsOutboundSocketFactory.class.getName());
    properties.setProperty(
        "jacorb.ssl.server_socket_factory", TlsInboundSocketFactory.class.getName());
    for (String side : new String[] {"server", "corbaloc_ssliop"}) {
      properties.setProperty("jacorb.security.ssl." + side + ".supported_options", MUTUAL);
      properties.setProperty("jacorb.security.ssl." + side + ".required_options", MUTUAL);
    }
    properties.setProperty("jacorb.security.ssl.client.supported_options", MUTUAL);
    properties.setProperty("jacorb.security.ssl.client.required_options", ENCRYPTED);
  }

  private static String privateLoopbackAddress() {
    ThreadLocalRandom random = ThreadLocalRandom.current();
    String address =
        "127."
            + random.nextInt(1, 255)
            + "."
            + random.nextInt(1, 255)
            + "."
            + random.nextInt(1, 255);
    try (ServerSocket probe = new ServerSocket(0, 1, InetAddress.getByName(address))) {
      return probe.getInetAddress().getHostAddress();
    } catch (IOException e) {
      // Not every system has all of 127.0.0.0/8; there a free port alone tells clients apart.
      return "127.0.0.1";
    }
  }
}
