package org.robonewbie.competition.team;

import java.text.Normalizer;
import java.util.Locale;
import java.util.regex.Pattern;
import org.robonewbie.nao.text.ConfusableCharacter;
import org.robonewbie.programs.CalledWronglyException;

/**
 * Name of a team: letters of any language, digits and underscores. SimSpark's messages, file names and program options
 * use a transliteration, because league agents and monitors support only ASCII.
 *
 * @param written the original, such as {@code Röt}
 * @param ascii the transliteration, such as {@code Roet}
 */
record TeamName(String written, String ascii) {

    static final int MAX_LETTERS = 20;

    private static final int LETTERS_OF_NUMBER = 3;

    private static final Pattern POSSIBLE = Pattern.compile("[\\p{L}\\p{M}\\p{N}_]+");
    private static final Pattern OF_WINDOWS =
            Pattern.compile("con|prn|aux|nul|com[0-9]|lpt[0-9]", Pattern.CASE_INSENSITIVE);

    /** Letters for which removing an accent is not enough, each followed by its transliteration. */
    private static final String[] SPELLINGS = ("ä ae ö oe ü ue ß ss æ ae œ oe ø o đ d ð d ł l þ th ı i ħ h"
                    + " а a б b в v г g д d е e ё e ж zh з z и i й y к k л l м m н n о o п p р r с s т t у u ф f х kh ц ts"
                    + " ч ch ш sh щ shch ъ _ ы y ь _ э e ю yu я ya і i ї yi є ye ґ g"
                    + " α a β v γ g δ d ε e ζ z η i θ th ι i κ k λ l μ m ν n ξ x ο o π p ρ r σ s ς s τ t υ y φ f χ ch ψ ps ω o")
            .split(" ", -1);

    /**
     * Parses a name.
     *
     * @param name the original
     * @throws CalledWronglyException if it is not a valid team name; the message suggests one
     */
    static TeamName of(String name) {
        String written = Normalizer.normalize(name, Normalizer.Form.NFC);
        ConfusableCharacter.firstIn(written).ifPresent(character -> {
            throw new CalledWronglyException("In the team name \"" + name + "\", " + character + ".");
        });
        boolean tooLong = written.codePointCount(0, written.length()) > MAX_LETTERS;
        if (tooLong
                || !POSSIBLE.matcher(written).matches()
                || OF_WINDOWS.matcher(written).matches()) {
            String proposal = near(written).written();
            throw new CalledWronglyException("\"" + name + "\" cannot be the name of a team. Use up to " + MAX_LETTERS
                    + " letters, digits and underscores, such as " + proposal + "; " + proposal
                    + ".title can hold a longer name.");
        }
        return new TeamName(written, shortened(inAscii(written), MAX_LETTERS));
    }

    /** Derives a valid name from any text. */
    static TeamName near(String text) {
        String possible = text.replaceAll("[^\\p{L}\\p{M}\\p{N}_]+", "_");
        String stripped = possible.replaceAll("^_+|_+$", "");
        String name = shortened(stripped.isEmpty() ? "Team" : stripped, MAX_LETTERS);
        return of(OF_WINDOWS.matcher(name).matches() ? "Team_" + name : name);
    }

    /** Returns the name with a number appended. */
    TeamName numbered(int number) {
        return of(shortened(written, MAX_LETTERS - LETTERS_OF_NUMBER) + "_" + number);
    }

    /** Returns whether the names are equal in messages, or in file names on a system that ignores case. */
    boolean collidesWith(TeamName other) {
        return ascii.equalsIgnoreCase(other.ascii);
    }

    private static String inAscii(String name) {
        StringBuilder ascii = new StringBuilder();
        name.codePoints().forEach(code -> ascii.append(inAscii(code)));
        return ascii.toString();
    }

    private static String inAscii(int code) {
        String letter = Character.toString(code);
        String small = letter.toLowerCase(Locale.ROOT);
        for (int i = 0; i < SPELLINGS.length; i += 2) {
            if (SPELLINGS[i].equals(small)) {
                String spelt = SPELLINGS[i + 1];
                return letter.equals(small)
                        ? spelt
                        : spelt.substring(0, 1).toUpperCase(Locale.ROOT) + spelt.substring(1);
            }
        }
        String base = Normalizer.normalize(letter, Normalizer.Form.NFKD).replaceAll("\\p{M}", "");
        if (base.equals(letter)) {
            return code < 0x80 ? letter : "u" + Integer.toHexString(code);
        }
        return inAscii(base);
    }

    private static String shortened(String name, int letters) {
        return name.codePointCount(0, name.length()) <= letters
                ? name
                : name.substring(0, name.offsetByCodePoints(0, letters));
    }
}
