package org.robonewbie.studio.roboviz;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;

/** Builder of RoboViz datagrams. */
public final class Datagram {

    private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();

    public Datagram bytes(int... values) {
        for (int value : values) {
            bytes.write(value);
        }
        return this;
    }

    public Datagram numbers(String... sixLetters) {
        for (String number : sixLetters) {
            bytes.writeBytes(number.getBytes(StandardCharsets.US_ASCII));
        }
        return this;
    }

    public Datagram text(String text) {
        bytes.writeBytes(text.getBytes(StandardCharsets.UTF_8));
        bytes.write(0);
        return this;
    }

    public byte[] done() {
        return bytes.toByteArray();
    }
}
