package org.robonewbie.pagejvm;

/** Jump instructions. */
final class Jumping {

    private Jumping() {}

    static void execute(int code, Frame frame) {
        switch (code) {
            case 167 -> frame.jump(frame.s2());
            case 200 -> frame.jump(frame.s4());
            case 170 -> table(frame);
            case 171 -> lookup(frame);
            case 168, 169 -> throw new Missing("The program was compiled for a Java version before 6");
            default -> {
                int offset = frame.s2();
                if (holds(code, frame)) {
                    frame.jump(offset);
                }
            }
        }
    }

    private static boolean holds(int code, Frame frame) {
        if (code >= 198) {
            return (frame.pop() == null) == (code == 198);
        }
        if (code >= 165) {
            Object other = frame.pop();
            return (frame.pop() == other) == (code == 165);
        }
        int right = code >= 159 ? frame.popInt() : 0;
        int left = frame.popInt();
        return switch ((code - 153) % 6) {
            case 0 -> left == right;
            case 1 -> left != right;
            case 2 -> left < right;
            case 3 -> left >= right;
            case 4 -> left > right;
            default -> left <= right;
        };
    }

    private static void align(Frame frame) {
        frame.next = frame.next + 3 & ~3;
    }

    private static void table(Frame frame) {
        align(frame);
        int otherwise = frame.s4();
        int low = frame.s4();
        int high = frame.s4();
        int value = frame.popInt();
        if (value < low || value > high) {
            frame.jump(otherwise);
        } else {
            frame.next += (value - low) * Integer.BYTES;
            frame.jump(frame.s4());
        }
    }

    private static void lookup(Frame frame) {
        align(frame);
        int target = frame.s4();
        int value = frame.popInt();
        for (int i = frame.s4(); i > 0; i--) {
            int match = frame.s4();
            int offset = frame.s4();
            if (match == value) {
                target = offset;
            }
        }
        frame.jump(target);
    }
}
