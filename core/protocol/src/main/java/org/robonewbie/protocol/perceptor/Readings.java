package org.robonewbie.protocol.perceptor;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.sexp.SexpReader;
import org.robonewbie.protocol.sexp.Token;

/**
 * Parsers for the number or vector that follows the current atom. Each returns an empty result if a number is missing.
 */
final class Readings {

    private Readings() {}

    static OptionalDouble number(SexpReader reader) {
        return reader.nextNumber() ? OptionalDouble.of(reader.number()) : OptionalDouble.empty();
    }

    static OptionalInt integer(SexpReader reader) {
        return reader.nextNumber() ? OptionalInt.of(reader.integer()) : OptionalInt.empty();
    }

    /** Parses the number in the list {@code name} of the current list; empty unless the current list is complete. */
    static OptionalDouble numberIn(SexpReader reader, String name) {
        OptionalDouble number = OptionalDouble.empty();
        int depth = reader.depth();
        while (reader.nextList(depth)) {
            if (reader.atomIs(name)) {
                number = number(reader);
            }
        }
        return isComplete(reader) ? number : OptionalDouble.empty();
    }

    /** Parses the vector in the list {@code name} of the current list; empty unless the current list is complete. */
    static Optional<Vector3> vectorIn(SexpReader reader, String name) {
        Optional<Vector3> vector = Optional.empty();
        int depth = reader.depth();
        while (reader.nextList(depth)) {
            if (reader.atomIs(name)) {
                vector = vector(reader);
            }
        }
        return isComplete(reader) ? vector : Optional.empty();
    }

    /** Returns whether the list that has just been read ends with a parenthesis. */
    static boolean isComplete(SexpReader reader) {
        return reader.token() == Token.CLOSE;
    }

    static Optional<Vector3> vector(SexpReader reader) {
        if (!reader.nextNumber()) {
            return Optional.empty();
        }
        double x = reader.number();
        if (!reader.nextNumber()) {
            return Optional.empty();
        }
        double y = reader.number();
        if (!reader.nextNumber()) {
            return Optional.empty();
        }
        return Optional.of(new Vector3(x, y, reader.number()));
    }
}
