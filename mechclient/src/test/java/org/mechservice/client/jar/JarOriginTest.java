package org.mechservice.client.jar;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.charset.StandardCharsets;
import java.security.GeneralSecurityException;
import java.security.KeyPair;
import java.security.KeyPairGenerator;
import java.security.Signature;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.mechservice.client.failure.JarRefusedException;

class JarOriginTest {
  private static final byte[] JAR = "a JAR".getBytes(StandardCharsets.US_ASCII);

  private static KeyPair newKey() throws GeneralSecurityException {
    KeyPairGenerator generator = KeyPairGenerator.getInstance("EC");
    generator.initialize(256);
    return generator.generateKeyPair();
  }

  private static byte[] signed(KeyPair key, byte[] bytes) throws GeneralSecurityException {
    Signature signature = Signature.getInstance("SHA256withECDSA");
    signature.initSign(key.getPrivate());
    signature.update(bytes);
    return signature.sign();
  }

  @Test
  void jarSignedByItsServerIsTaken() throws Exception {
    KeyPair server = newKey();
    JarOrigin origin = new JarOrigin(true, Optional.of(server.getPublic()));
    assertThat(origin.verified(JAR, signed(server, JAR), "the model JAR")).isSameAs(JAR);
  }

  @Test
  void changedOrForeignOrUnsignedJarIsRefused() throws Exception {
    KeyPair server = newKey();
    JarOrigin origin = new JarOrigin(true, Optional.of(server.getPublic()));
    byte[] changed = JAR.clone();
    changed[2] = 'B';
    byte[][] signatures = {signed(server, changed), signed(newKey(), JAR), {1, 2, 3}};
    for (byte[] signature : signatures) {
      assertThatThrownBy(() -> origin.verified(JAR, signature, "the model JAR"))
          .isInstanceOf(JarRefusedException.class)
          .hasMessageStartingWith("S-154 the model JAR is not signed with the key of the server");
    }
    assertThatThrownBy(() -> origin.verified(JAR, new byte[0], "the model JAR"))
        .hasMessage("S-154 the model JAR is not signed; it was not loaded");
    JarOrigin unknown = new JarOrigin(true, Optional.empty());
    assertThatThrownBy(() -> unknown.verified(JAR, signed(server, JAR), "the model JAR"))
        .isInstanceOf(JarRefusedException.class);
  }

  @Test
  void withoutTlsTheHashIsAllThereIs() {
    JarOrigin plain = new JarOrigin(false, Optional.empty());
    assertThat(plain.verified(JAR, new byte[0], "the model JAR")).isSameAs(JAR);
  }
}
