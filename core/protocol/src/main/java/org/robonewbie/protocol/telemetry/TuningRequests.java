package org.robonewbie.protocol.telemetry;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.function.Predicate;

/**
 * Pending requests to tune the parameters of robots. Thread-safe.
 *
 * <pre>{@code
 * requests.put(new TuningRequest("Blue", 3, "gain", 0.75));
 * OptionalDouble gain = requests.take("Blue", 3, "gain");
 * }</pre>
 */
public final class TuningRequests {

    private static final int MAX_PENDING = 1000;

    private final Map<String, Double> pending = new LinkedHashMap<>();
    private final List<Predicate<TuningRequest>> forwarders = new ArrayList<>();
    private volatile boolean empty = true;

    /** Creates an empty collection. */
    public TuningRequests() {}

    /**
     * Forwards a request to a robot in another process. If no forwarder reaches the robot, the request stays pending and
     * replaces an older one for the same parameter.
     *
     * @param request the request
     */
    public synchronized void put(TuningRequest request) {
        boolean forwarded = forwarders.stream().anyMatch(forwarder -> forwarder.test(request));
        if (!forwarded && pending.size() < MAX_PENDING) {
            pending.put(key(request.team(), request.number(), request.name()), request.value());
            empty = false;
        }
    }

    /**
     * Removes the pending request for a parameter.
     *
     * @param team name of the robot's team
     * @param number the robot's shirt number
     * @param name name of the parameter in the program
     * @return the requested value; empty if there is no request
     */
    public OptionalDouble take(String team, int number, String name) {
        return empty ? OptionalDouble.empty() : taken(key(team, number, name));
    }

    private synchronized OptionalDouble taken(String key) {
        Double value = pending.remove(key);
        empty = pending.isEmpty();
        return value == null ? OptionalDouble.empty() : OptionalDouble.of(value);
    }

    /**
     * Adds a function that forwards requests to robots in another process.
     *
     * @param forwarder sends a request and returns whether it reaches the robot
     */
    public synchronized void addForwarder(Predicate<TuningRequest> forwarder) {
        forwarders.add(forwarder);
    }

    /**
     * Removes a forwarder.
     *
     * @param forwarder a previously added forwarder
     */
    public synchronized void removeForwarder(Predicate<TuningRequest> forwarder) {
        forwarders.remove(forwarder);
    }

    private static String key(String team, int number, String name) {
        return team + "\t" + number + "\t" + name;
    }
}
