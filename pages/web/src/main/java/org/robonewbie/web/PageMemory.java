package org.robonewbie.web;

import java.util.HashMap;
import java.util.Map;
import java.util.function.Supplier;

/**
 * What classes know that stand in the place of others in the page. They cannot keep it themselves: TeaVM compiles a copy of each under
 * the other name, with static fields of its own.
 */
public final class PageMemory {

    private static final StackTraceElement[] NO_CALLS = {};
    private static final Map<String, byte[]> MOTIONS = new HashMap<>();

    private static Supplier<StackTraceElement[]> program = () -> NO_CALLS;

    private PageMemory() {}

    /**
     * Looks at a program from now on.
     *
     * @param calls tells its calls, the innermost first
     */
    static void lookAt(Supplier<StackTraceElement[]> calls) {
        program = calls;
    }

    /** {@return the calls of the program that is carried out, the innermost first} */
    public static StackTraceElement[] calls() {
        return program.get();
    }

    /** {@return the motions that somebody has made in the page: the bytes of each file by name} */
    public static Map<String, byte[]> motions() {
        return MOTIONS;
    }
}
