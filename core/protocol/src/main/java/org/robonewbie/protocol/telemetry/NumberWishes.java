package org.robonewbie.protocol.telemetry;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.function.Predicate;

/**
 * What people want of the numbers of robots, until the robots take it. Any thread may ask.
 *
 * <pre>{@code
 * wishes.put(new NumberWish("Blue", 3, "gain", 0.75));
 * OptionalDouble gain = wishes.take("Blue", 3, "gain");
 * }</pre>
 */
public final class NumberWishes {

    private static final int MAX_WAITING = 1000;

    private final Map<String, Double> waiting = new LinkedHashMap<>();
    private final List<Predicate<NumberWish>> messengers = new ArrayList<>();
    private volatile boolean empty = true;

    /** Creates an empty collection. */
    public NumberWishes() {}

    /**
     * Hands a wish on to a messenger that reaches its robot; else the wish waits for the robot and takes the place of an older one.
     *
     * @param wish the wish
     */
    public synchronized void put(NumberWish wish) {
        boolean handedOn = messengers.stream().anyMatch(messenger -> messenger.test(wish));
        if (!handedOn && waiting.size() < MAX_WAITING) {
            waiting.put(key(wish.team(), wish.number(), wish.name()), wish.value());
            empty = false;
        }
    }

    /**
     * Takes the wish for a number.
     *
     * @param team name of the robot's team
     * @param number its shirt number
     * @param name what the program calls the number
     * @return the wanted value; empty if nobody wants another one
     */
    public OptionalDouble take(String team, int number, String name) {
        return empty ? OptionalDouble.empty() : taken(key(team, number, name));
    }

    private synchronized OptionalDouble taken(String key) {
        Double value = waiting.remove(key);
        empty = waiting.isEmpty();
        return value == null ? OptionalDouble.empty() : OptionalDouble.of(value);
    }

    /**
     * Adds a messenger to robots elsewhere.
     *
     * @param messenger hands a wish on, and returns whether it reaches the robot
     */
    public synchronized void sendBy(Predicate<NumberWish> messenger) {
        messengers.add(messenger);
    }

    /**
     * Takes a messenger away.
     *
     * @param messenger one that was added
     */
    public synchronized void sendNoMoreBy(Predicate<NumberWish> messenger) {
        messengers.remove(messenger);
    }

    private static String key(String team, int number, String name) {
        return team + "\t" + number + "\t" + name;
    }
}
