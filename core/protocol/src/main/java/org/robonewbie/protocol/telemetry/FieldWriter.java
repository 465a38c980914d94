package org.robonewbie.protocol.telemetry;

import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.math.PortableMath;

/** Formats tab-separated fields. */
final class FieldWriter {

    private static final double DECIMALS = 10_000;

    private final StringBuilder line;

    FieldWriter(String kind) {
        line = new StringBuilder(kind);
    }

    FieldWriter text(String text) {
        line.append('\t');
        for (int i = 0; i < text.length(); i++) {
            append(text.charAt(i));
        }
        return this;
    }

    /** Writes a number with four decimal places, which is precise enough for display. */
    FieldWriter number(double value) {
        line.append('\t').append(Double.isFinite(value) ? PortableMath.rint(value * DECIMALS) / DECIMALS : value);
        return this;
    }

    FieldWriter vector(Vector3 vector) {
        return number(vector.x()).number(vector.y()).number(vector.z());
    }

    private void append(char character) {
        switch (character) {
            case '\t' -> line.append("\\t");
            case '\n' -> line.append("\\n");
            case '\r' -> line.append("\\r");
            case '\\' -> line.append("\\\\");
            default -> line.append(character);
        }
    }

    @Override
    public String toString() {
        return line.toString();
    }
}
