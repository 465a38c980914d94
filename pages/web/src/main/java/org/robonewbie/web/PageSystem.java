package org.robonewbie.web;

import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.robonewbie.pagejvm.ArrayCopy;
import org.robonewbie.pagejvm.ProgramEnd;
import org.robonewbie.pagejvm.SpecialCalls;

/** Replacements for methods of {@code System}. */
final class PageSystem {

    private PageSystem() {}

    /**
     * Executes a call.
     *
     * @param name name of the method
     * @param arguments its arguments
     * @return its result, or {@link SpecialCalls#UNKNOWN} if the method is not replaced
     */
    static @Nullable Object call(String name, @Nullable Object[] arguments) {
        return switch (name) {
            case "exit" -> throw new ProgramEnd((Integer) Objects.requireNonNull(arguments[0]));
            case "getenv" -> null;
            case "arraycopy" -> {
                ArrayCopy.copy(
                        Objects.requireNonNull(arguments[0]),
                        (Integer) Objects.requireNonNull(arguments[1]),
                        Objects.requireNonNull(arguments[2]),
                        (Integer) Objects.requireNonNull(arguments[3]),
                        (Integer) Objects.requireNonNull(arguments[4]));
                yield null;
            }
            default -> SpecialCalls.UNKNOWN;
        };
    }
}
