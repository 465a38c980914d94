package org.robonewbie.simulator.script;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;
import org.robonewbie.nao.math.PortableMath;

/**
 * Recursive-descent evaluator of Ruby expressions that consist of numbers, strings, {@code true}, {@code false} and
 * variables with known values. Integer division rounds down.
 */
final class RubyExpression {

    private static final Pattern LEGAL_NUMBER =
            Pattern.compile("0[xX]\\p{XDigit}+(?:_\\p{XDigit}+)*|0[bB][01]+(?:_[01]+)*|0[oO_]?[0-7]+(?:_[0-7]+)*"
                    + "|(?:0|[1-9]\\d*(?:_\\d+)*)(?:\\.\\d+(?:_\\d+)*)?(?:[eE][-+]?\\d+(?:_\\d+)*)?");

    /** Maximum number of tokens in an evaluated expression, which bounds the nesting of brackets. */
    private static final int MAX_TOKENS = 200;

    private final List<RubyToken> tokens;
    private final Map<String, Object> variables;
    private int at;

    private RubyExpression(List<RubyToken> tokens, Map<String, Object> variables) {
        this.tokens = tokens;
        this.variables = variables;
    }

    /** Thrown for an expression that this evaluator does not support. */
    private static final class UnknownValueException extends RuntimeException {

        private static final long serialVersionUID = 1L;
    }

    /**
     * Evaluates an expression.
     *
     * @param tokens the expression
     * @param variables values of the known variables
     * @return a Long, Double, Boolean or String; empty if the expression cannot be evaluated
     */
    static Optional<Object> value(List<RubyToken> tokens, Map<String, Object> variables) {
        if (tokens.size() > MAX_TOKENS) {
            return Optional.empty();
        }
        try {
            RubyExpression expression = new RubyExpression(tokens, variables);
            Object value = expression.sum();
            return expression.at == tokens.size() ? Optional.of(value) : Optional.empty();
        } catch (UnknownValueException | ArithmeticException | NumberFormatException onlyRuby) {
            return Optional.empty();
        }
    }

    private Object sum() {
        Object value = product();
        while (isNext("+") || isNext("-")) {
            value = calculated(tokens.get(at++).text(), value, product());
        }
        return value;
    }

    private Object product() {
        Object value = signed();
        while (isNext("*") || isNext("/") || isNext("%")) {
            value = calculated(tokens.get(at++).text(), value, signed());
        }
        return value;
    }

    private Object signed() {
        if (isNext("-")) {
            at++;
            return calculated("-", 0L, signed());
        }
        if (isNext("+")) {
            at++;
            return calculated("+", 0L, signed());
        }
        Object base = operand();
        if (isNext("**")) {
            at++;
            return calculated("**", base, signed());
        }
        return base;
    }

    private Object operand() {
        if (at >= tokens.size()) {
            throw new UnknownValueException();
        }
        RubyToken token = tokens.get(at++);
        if (token.isSign("(")) {
            Object value = sum();
            if (!isNext(")")) {
                throw new UnknownValueException();
            }
            at++;
            return value;
        }
        return switch (token.kind()) {
            case NUMBER -> number(token.text());
            case STRING -> token.text();
            case WORD, GLOBAL -> variable(token.text());
            default -> throw new UnknownValueException();
        };
    }

    private Object variable(String name) {
        Object value = switch (name) {
            case "true" -> true;
            case "false" -> false;
            default -> variables.get(name);
        };
        if (value == null) {
            throw new UnknownValueException();
        }
        return value;
    }

    private static Object number(String text) {
        if (!LEGAL_NUMBER.matcher(text).matches()) {
            throw new UnknownValueException();
        }
        String digits = text.replace("_", "");
        boolean octal = digits.matches("0[oO]?[0-7]+");
        if (octal || digits.matches("0[xXbB].*")) {
            String base = digits.replaceFirst("^0[xXbBoO]?", "");
            return Long.valueOf(base, octal ? 8 : digits.matches("0[xX].*") ? 16 : 2);
        }
        return digits.matches("\\d+") ? (Object) Long.valueOf(digits) : (Object) Double.valueOf(digits);
    }

    private static Object calculated(String sign, Object first, Object second) {
        if (first instanceof Long one && second instanceof Long other) {
            return whole(sign, one, other);
        }
        if (first instanceof Number one && second instanceof Number other) {
            return real(sign, one.doubleValue(), other.doubleValue());
        }
        if (first instanceof String one && second instanceof String other && sign.equals("+")) {
            return one + other;
        }
        throw new UnknownValueException();
    }

    private static Object whole(String sign, long first, long second) {
        return switch (sign) {
            case "+" -> Math.addExact(first, second);
            case "-" -> Math.subtractExact(first, second);
            case "*" -> Math.multiplyExact(first, second);
            case "/" -> Math.floorDiv(first, second);
            case "%" -> Math.floorMod(first, second);
            default -> power(first, second);
        };
    }

    private static Object power(long base, long exponent) {
        double value = PortableMath.pow((double) base, (double) exponent);
        if (exponent < 0 || Math.abs(value) >= 1L << 53) {
            throw new UnknownValueException();
        }
        return (long) value;
    }

    private static Object real(String sign, double first, double second) {
        return switch (sign) {
            case "+" -> first + second;
            case "-" -> first - second;
            case "*" -> first * second;
            case "/" -> first / second;
            case "%" -> first - second * Math.floor(first / second);
            default -> PortableMath.pow(first, second);
        };
    }

    private boolean isNext(String sign) {
        return at < tokens.size() && tokens.get(at).isSign(sign);
    }
}
