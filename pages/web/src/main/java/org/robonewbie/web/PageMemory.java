package org.robonewbie.web;

import java.util.HashMap;
import java.util.Map;
import java.util.function.Supplier;

/**
 * State of the classes that replace library and framework classes in the page. The replacements cannot hold this state themselves, because
 * TeaVM compiles a copy of each under the name of the replaced class, with separate static fields.
 */
public final class PageMemory {

    private static final StackTraceElement[] NO_CALLS = {};
    private static final Map<String, byte[]> MOTIONS = new HashMap<>();

    private static Supplier<StackTraceElement[]> program = () -> NO_CALLS;

    private PageMemory() {}

    /**
     * Sets the running program.
     *
     * @param calls returns the program's call stack, the innermost call first
     */
    static void setProgram(Supplier<StackTraceElement[]> calls) {
        program = calls;
    }

    /** {@return the call stack of the running program, the innermost call first} */
    public static StackTraceElement[] calls() {
        return program.get();
    }

    /** {@return the user's motions in the page: bytes of each file by name} */
    public static Map<String, byte[]> motions() {
        return MOTIONS;
    }
}
