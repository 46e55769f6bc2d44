// Every texture lookup of a search is counted: that costs nothing where the program does not read it.

int reliefFetchCount = 0;
