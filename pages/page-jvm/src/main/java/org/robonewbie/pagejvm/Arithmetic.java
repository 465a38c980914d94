package org.robonewbie.pagejvm;

import java.util.Objects;

/** Arithmetic, conversion and comparison instructions. */
final class Arithmetic {

    private Arithmetic() {}

    static void execute(int code, Frame frame) {
        if (code == 132) {
            int local = frame.u1();
            frame.locals[local] = (Integer) Objects.requireNonNull(frame.locals[local]) + frame.s1();
        } else if (code >= 148) {
            frame.push(comparison(code, frame));
        } else if (code >= 133) {
            frame.push(conversion(code, frame.popObject()));
        } else if (code >= 120) {
            frame.push(bits(code, frame));
        } else if (code >= 116) {
            frame.push(negation(frame.popObject()));
        } else {
            calculate(code, frame);
        }
    }

    /** Executes the opcodes from 96 on: add, subtract, multiply, divide, remainder; each for int, long, float, double. */
    private static void calculate(int code, Frame frame) {
        int operation = (code - 96) / 4;
        switch ((code - 96) % 4) {
            case 0 -> {
                int right = frame.popInt();
                frame.push(calculate(operation, frame.popInt(), right));
            }
            case 1 -> {
                long right = frame.popLong();
                frame.push(calculate(operation, frame.popLong(), right));
            }
            case 2 -> {
                float right = frame.popFloat();
                frame.push(calculate(operation, frame.popFloat(), right));
            }
            default -> {
                double right = frame.popDouble();
                frame.push(calculate(operation, frame.popDouble(), right));
            }
        }
    }

    private static int calculate(int operation, int left, int right) {
        return switch (operation) {
            case 0 -> left + right;
            case 1 -> left - right;
            case 2 -> left * right;
            case 3 -> left / notZero(right);
            default -> left % notZero(right);
        };
    }

    private static long calculate(int operation, long left, long right) {
        if (operation >= 3 && right == 0) {
            throw new ArithmeticException("/ by zero");
        }
        return switch (operation) {
            case 0 -> left + right;
            case 1 -> left - right;
            case 2 -> left * right;
            case 3 -> left / right;
            default -> left % right;
        };
    }

    private static int notZero(int divisor) {
        if (divisor == 0) {
            throw new ArithmeticException("/ by zero");
        }
        return divisor;
    }

    private static float calculate(int operation, float left, float right) {
        return switch (operation) {
            case 0 -> left + right;
            case 1 -> left - right;
            case 2 -> left * right;
            case 3 -> left / right;
            default -> left % right;
        };
    }

    private static double calculate(int operation, double left, double right) {
        return switch (operation) {
            case 0 -> left + right;
            case 1 -> left - right;
            case 2 -> left * right;
            case 3 -> left / right;
            default -> left % right;
        };
    }

    private static Object negation(Object value) {
        if (value instanceof Integer number) {
            return -number;
        }
        if (value instanceof Long number) {
            return -number;
        }
        return value instanceof Float number ? (Object) (-number) : (Object) (-(Double) value);
    }

    /**
     * Executes the opcodes from 120 on: shift left, right, unsigned right; and, or, exclusive or; each for int and long.
     */
    private static Object bits(int code, Frame frame) {
        Object right = frame.popObject();
        int operation = (code - 120) / 2;
        if (code % 2 == 0) {
            int left = frame.popInt();
            int by = (Integer) right;
            return switch (operation) {
                case 0 -> left << by;
                case 1 -> left >> by;
                case 2 -> left >>> by;
                case 3 -> left & by;
                case 4 -> left | by;
                default -> left ^ by;
            };
        }
        long left = frame.popLong();
        long by = ((Number) right).longValue();
        return switch (operation) {
            case 0 -> left << by;
            case 1 -> left >> by;
            case 2 -> left >>> by;
            case 3 -> left & by;
            case 4 -> left | by;
            default -> left ^ by;
        };
    }

    private static Object conversion(int code, Object value) {
        return switch (code) {
            case 133, 140, 143 -> toLong(value);
            case 134, 137, 144 -> ((Number) value).floatValue();
            case 135, 138, 141 -> ((Number) value).doubleValue();
            case 136, 139, 142 -> toInt(value);
            case 145 -> (int) (byte) toInt(value);
            case 146 -> (int) (char) toInt(value);
            default -> (int) (short) toInt(value);
        };
    }

    private static int toInt(Object value) {
        if (value instanceof Double number) {
            return (int) (double) number;
        }
        return value instanceof Float number ? (int) (float) number : (int) ((Number) value).longValue();
    }

    private static long toLong(Object value) {
        if (value instanceof Double number) {
            return (long) (double) number;
        }
        return value instanceof Float number ? (long) (float) number : ((Number) value).longValue();
    }

    private static int comparison(int code, Frame frame) {
        if (code == 148) {
            long right = frame.popLong();
            return Long.compare(frame.popLong(), right);
        }
        double right = ((Number) frame.popObject()).doubleValue();
        double left = ((Number) frame.popObject()).doubleValue();
        if (Double.isNaN(left) || Double.isNaN(right)) {
            return code == 149 || code == 151 ? -1 : 1;
        }
        return left == right ? 0 : left < right ? -1 : 1;
    }
}
