package org.mechservice.load;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyStore;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.net.ssl.KeyManager;
import javax.net.ssl.KeyManagerFactory;
import javax.net.ssl.SSLContext;
import javax.net.ssl.TrustManagerFactory;
import org.mechservice.cli.Mech;
import org.mechservice.orb.tls.TlsIdentity;

/** The folders that {@code mech keys} makes: a server on the loopback interface, and users. */
record TlsKeys(Path folder) {
  /** The administrator. */
  static final String ROOT = "root";

  /** Makes keys for {@code server}, {@link #ROOT} and users. */
  static TlsKeys make(Path folder, String... users) {
    List<String> words =
        new ArrayList<>(
            List.of("keys", folder.toString(), "--host", "server,127.0.0.1", "--admin", ROOT));
    for (String user : users) {
      words.addAll(List.of("--client", user));
    }
    PrintWriter nowhere = new PrintWriter(new StringWriter());
    assertThat(Mech.run(nowhere, nowhere, words.toArray(String[]::new))).isZero();
    return new TlsKeys(folder);
  }

  /** Returns the folder of a name, as {@code --tls} has it. */
  String of(String name) {
    return folder.resolve(name).toString();
  }

  Optional<TlsIdentity> identity(String name) {
    return Optional.of(TlsIdentity.load(folder.resolve(name)));
  }

  /**
   * Returns what a program of its own connects with.
   *
   * @param shown whether the certificate is shown, or none
   */
  SSLContext context(String name, boolean shown) throws IOException, GeneralSecurityException {
    Path own = folder.resolve(name);
    char[] password =
        Files.readString(own.resolve(TlsIdentity.PASSWORD_FILE)).strip().toCharArray();
    KeyManagerFactory keys = KeyManagerFactory.getInstance("PKIX");
    keys.init(store(own.resolve(TlsIdentity.KEY_FILE), password), password);
    TrustManagerFactory trust = TrustManagerFactory.getInstance("PKIX");
    trust.init(store(own.resolve(TlsIdentity.TRUST_FILE), password));
    SSLContext context = SSLContext.getInstance("TLS");
    context.init(shown ? keys.getKeyManagers() : new KeyManager[0], trust.getTrustManagers(), null);
    return context;
  }

  private static KeyStore store(Path file, char[] password)
      throws IOException, GeneralSecurityException {
    KeyStore store = KeyStore.getInstance("PKCS12");
    try (InputStream in = Files.newInputStream(file)) {
      store.load(in, password);
    }
    return store;
  }
}
