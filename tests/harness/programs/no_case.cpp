// No case at all: a program whose cases were lost on the way must not end well.
