package org.robonewbie.programs.process;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;
import java.util.Optional;

/**
 * Seccomp filter that denies the system calls that allocate memory outside processes and file systems, which the resource
 * limits do not cover: System V shared memory and message queues, and in-memory files. It is a classic BPF program over {@code
 * struct seccomp_data}, see {@code seccomp(2)}.
 *
 * @param architecture audit number of the processor architecture, as in {@code linux/audit.h}
 * @param calls numbers of the denied system calls
 */
record SystemCallFilter(int architecture, List<Integer> calls) {

    private static final SystemCallFilter X86_64 = new SystemCallFilter(0xC000003E, List.of(29, 68, 319, 447));
    private static final SystemCallFilter AARCH64 = new SystemCallFilter(0xC00000B7, List.of(194, 186, 279, 447));

    private static final int INSTRUCTION_BYTES = 8;
    private static final int NUMBER_OFFSET = 0;
    private static final int ARCHITECTURE_OFFSET = 4;
    private static final int FIRST_OF_OTHER_TABLE = 0x40000000;

    private static final int LOAD = 0x20;
    private static final int JUMP_IF_EQUAL = 0x15;
    private static final int JUMP_IF_AT_LEAST = 0x35;
    private static final int RETURN = 0x06;

    private static final int ALLOW = 0x7FFF0000;
    private static final int NO_SUCH_CALL = 0x00050026;

    /** Makes the list unmodifiable. */
    SystemCallFilter {
        calls = List.copyOf(calls);
    }

    /** Returns the filter for this processor; empty if its system calls are unknown. */
    static Optional<SystemCallFilter> ofThisProcessor() {
        return switch (System.getProperty("os.arch")) {
            case "amd64", "x86_64" -> Optional.of(X86_64);
            case "aarch64" -> Optional.of(AARCH64);
            default -> Optional.empty();
        };
    }

    /**
     * Encodes the filter in the format of {@code bwrap --seccomp}. Programs for another architecture, such as 32-bit ones, are
     * denied all calls.
     */
    byte[] toBytes() {
        int length = calls.size() + 6;
        ByteBuffer program = ByteBuffer.allocate(length * INSTRUCTION_BYTES).order(ByteOrder.nativeOrder());
        int denial = length - 1;
        add(program, LOAD, 0, 0, ARCHITECTURE_OFFSET);
        add(program, JUMP_IF_EQUAL, 0, denial - 2, architecture);
        add(program, LOAD, 0, 0, NUMBER_OFFSET);
        add(program, JUMP_IF_AT_LEAST, denial - 4, 0, FIRST_OF_OTHER_TABLE);
        for (int i = 0; i < calls.size(); i++) {
            add(program, JUMP_IF_EQUAL, denial - 5 - i, 0, calls.get(i));
        }
        add(program, RETURN, 0, 0, ALLOW);
        add(program, RETURN, 0, 0, NO_SUCH_CALL);
        return program.array();
    }

    private static void add(ByteBuffer program, int code, int skippedIfTrue, int skippedIfFalse, int value) {
        program.putShort((short) code)
                .put((byte) skippedIfTrue)
                .put((byte) skippedIfFalse)
                .putInt(value);
    }
}
