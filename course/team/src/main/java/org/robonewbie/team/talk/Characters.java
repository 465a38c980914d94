package org.robonewbie.team.talk;

import java.util.Optional;

/**
 * Numbers as text. A message has at most 20 characters, and not every character may be said: blanks and brackets are forbidden, and
 * quotation marks confuse some servers. 64 others are enough to put six bits into each.
 *
 * <p>The last five bits are a check sum: programs of other teams say things too, and a text that means something else must not be
 * taken for a message.
 */
final class Characters {

    private static final String ALPHABET = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz+-";
    private static final int BITS_PER_CHARACTER = 6;
    private static final int LENGTH = 18;
    private static final int CHECK_BITS = 5;
    private static final int ALL_BITS = LENGTH * BITS_PER_CHARACTER;

    private final boolean[] bits = new boolean[ALL_BITS];
    private int next;

    /** Takes a text apart; empty if it cannot be a message of this team. */
    static Optional<Characters> of(String text) {
        if (text.length() != LENGTH || text.chars().anyMatch(letter -> ALPHABET.indexOf(letter) < 0)) {
            return Optional.empty();
        }
        Characters result = new Characters();
        for (int i = 0; i < LENGTH; i++) {
            result.write(ALPHABET.indexOf(text.charAt(i)), BITS_PER_CHARACTER);
        }
        result.next = ALL_BITS - CHECK_BITS;
        boolean right = result.read(CHECK_BITS) == result.checkSum();
        result.next = 0;
        return right ? Optional.of(result) : Optional.empty();
    }

    /** Writes a whole number from 0 on. */
    void write(int number, int width) {
        for (int bit = width - 1; bit >= 0; bit--) {
            bits[next++] = ((number >> bit) & 1) == 1;
        }
    }

    /** Writes a number between two limits as exactly as the bits allow; what is beyond them becomes the limit. */
    void write(double value, int width, double least, double most) {
        int steps = (1 << width) - 1;
        double share = (value - least) / (most - least);
        write((int) Math.floor(Math.max(0, Math.min(1, Double.isNaN(share) ? 0 : share)) * steps + 0.5), width);
    }

    /** Reads a whole number. */
    int read(int width) {
        int number = 0;
        for (int i = 0; i < width; i++) {
            number = 2 * number + (bits[next++] ? 1 : 0);
        }
        return number;
    }

    /** Reads a number between two limits. */
    double read(int width, double least, double most) {
        return least + (most - least) * read(width) / ((1 << width) - 1);
    }

    /** Adds the check sum and returns the text. */
    String finish() {
        next = ALL_BITS - CHECK_BITS;
        write(checkSum(), CHECK_BITS);
        next = 0;
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < LENGTH; i++) {
            text.append(ALPHABET.charAt(read(BITS_PER_CHARACTER)));
        }
        return text.toString();
    }

    private int checkSum() {
        int sum = 0;
        for (int i = 0; i < ALL_BITS - CHECK_BITS; i++) {
            sum = (sum * 3 + (bits[i] ? i + 1 : 0)) % 31;
        }
        return sum;
    }
}
