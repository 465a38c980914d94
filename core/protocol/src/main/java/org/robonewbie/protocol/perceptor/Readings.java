package org.robonewbie.protocol.perceptor;

import java.util.Optional;
import java.util.OptionalDouble;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.sexp.SexpReader;

/**
 * Parsers for the number or vector that follows the current atom. Each returns an empty result if a number is missing.
 */
final class Readings {

    private Readings() {}

    static OptionalDouble number(SexpReader reader) {
        return reader.nextNumber() ? OptionalDouble.of(reader.number()) : OptionalDouble.empty();
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
